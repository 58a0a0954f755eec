# What a program outside this tree needs to embed the simulator: the library, its headers, and a package for find_package(npsee).
include(CMakePackageConfigHelpers)
set(npsee_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/npsee")
install(TARGETS npsee_sim EXPORT npsee_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/sim/include/npsee" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h")
install(EXPORT npsee_targets FILE npseeTargets.cmake NAMESPACE npsee:: DESTINATION "${npsee_package_dir}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/npseeConfig.cmake.in" "${PROJECT_BINARY_DIR}/npseeConfig.cmake" INSTALL_DESTINATION "${npsee_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/npseeConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/npseeConfig.cmake" "${PROJECT_BINARY_DIR}/npseeConfigVersion.cmake" DESTINATION "${npsee_package_dir}")
