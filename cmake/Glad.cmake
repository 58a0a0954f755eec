# GL 3.3 core functions through glad 2, generated at configure time. Asking for 3.3 only is the guard against an accidental
# use of newer functions, which software drivers would accept.
find_program(NPSEE_GLAD glad HINTS /usr/bin REQUIRED)
set(glad_dir "${CMAKE_BINARY_DIR}/glad")
if(NOT EXISTS "${glad_dir}/src/gl.c" OR NOT EXISTS "${glad_dir}/include/glad/gl.h")
  # --reproducible takes the registry that is packaged with glad, so nothing is fetched.
  execute_process(
    COMMAND "${NPSEE_GLAD}" --quiet --api gl:core=3.3 --extensions "" --reproducible --out-path "${glad_dir}" c
    RESULT_VARIABLE glad_result ERROR_VARIABLE glad_output OUTPUT_VARIABLE glad_output)
  if(NOT glad_result EQUAL 0)
    message(FATAL_ERROR "glad could not generate the GL loader (package python3-glad):\n${glad_output}")
  endif()
endif()
# Its own target: generated code does not meet our warning flags.
add_library(npsee_glad STATIC "${glad_dir}/src/gl.c")
target_include_directories(npsee_glad SYSTEM PUBLIC "${glad_dir}/include")
