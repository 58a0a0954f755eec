# What the fuzz targets are made of: compiled by clang for libFuzzer (CMakeLists.txt here) and by any compiler for the suite's short run of each.
# Of the program's other rooms only the readers and what they need.
set(fuzz_sources)
foreach(source IN ITEMS targets targets_app targets_missions targets_world)
  list(APPEND fuzz_sources "${CMAKE_CURRENT_LIST_DIR}/${source}.cpp")
endforeach()
foreach(source IN ITEMS app/render/deep_png app/render/png_text editor/script/keys editor/script/parser)
  list(APPEND fuzz_sources "${PROJECT_SOURCE_DIR}/${source}.cpp")
endforeach()
