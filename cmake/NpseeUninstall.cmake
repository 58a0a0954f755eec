# The target `uninstall` takes away what `cmake --install` put somewhere, and nothing else: files, then folders that were not there before.
# CMake's own install_manifest.txt is no help: a later cpack overwrites it. Included first and called last, around all install rules.
set(npsee_installed "${PROJECT_BINARY_DIR}/installed")
install(CODE "set(npsee_installed \"${npsee_installed}\")\ninclude(\"${CMAKE_CURRENT_LIST_DIR}/uninstall/before.cmake\")" ALL_COMPONENTS)
add_custom_target(uninstall COMMAND "${CMAKE_COMMAND}" "-DINSTALLED=${npsee_installed}" -P "${CMAKE_CURRENT_LIST_DIR}/uninstall/uninstall.cmake" VERBATIM)
set(npsee_uninstall_after "${CMAKE_CURRENT_LIST_DIR}/uninstall/after.cmake")
macro(npsee_note_installed)
  install(CODE "include(\"${npsee_uninstall_after}\")" ALL_COMPONENTS)
endmacro()
