# What a program outside this tree needs to embed the simulator: the libraries, their headers, a package for find_package(npsee) and, for
# the C interface, one for pkg-config.
include(CMakePackageConfigHelpers)
set(npsee_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/npsee")
install(TARGETS npsee_sim EXPORT npsee_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(TARGETS npsee_c EXPORT npsee_c_targets
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/sim/include/npsee" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development FILES_MATCHING PATTERN "*.h")
install(EXPORT npsee_targets FILE npseeTargets.cmake NAMESPACE npsee:: DESTINATION "${npsee_package_dir}" COMPONENT development)
install(EXPORT npsee_c_targets FILE npseeCTargets.cmake NAMESPACE npsee:: DESTINATION "${npsee_package_dir}" COMPONENT development)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/npseeConfig.cmake.in" "${PROJECT_BINARY_DIR}/npseeConfig.cmake" INSTALL_DESTINATION "${npsee_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/npseeConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/npseeConfig.cmake" "${PROJECT_BINARY_DIR}/npseeConfigVersion.cmake" DESTINATION "${npsee_package_dir}" COMPONENT development)
# From lib/pkgconfig, or lib/ARCHITECTURE/pkgconfig, up to the prefix.
string(REGEX REPLACE "[^/]+" ".." NPSEE_PC_UP "${CMAKE_INSTALL_LIBDIR}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/npsee.pc.in" "${PROJECT_BINARY_DIR}/npsee.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/npsee.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
