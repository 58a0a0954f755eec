# What people get of the program besides the executable: presets, missions and their files, manual pages, completion, a desktop entry with
# icons, file types; and packages of it all (`cpack --config CPackConfig.cmake` in the build folder makes a .deb, CPackSourceConfig.cmake a
# source archive). The program finds its files relative to itself, so that the tree can be unpacked anywhere.
set(npsee_data "${CMAKE_INSTALL_DATADIR}/npsee")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/presets" DESTINATION "${npsee_data}" COMPONENT program FILES_MATCHING PATTERN "*.npsee.json" PATTERN thumbnails EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/assets" DESTINATION "${npsee_data}" COMPONENT program PATTERN desktop EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/assets/desktop/npsee.desktop" DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT program)
install(FILES "${PROJECT_SOURCE_DIR}/assets/desktop/npsee.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" COMPONENT program)
foreach(size IN ITEMS 16 22 24 32 48 64 128 256 512)
  install(FILES "${PROJECT_SOURCE_DIR}/assets/desktop/icons/${size}.png" DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps"
    RENAME npsee.png COMPONENT program)
endforeach()
install(FILES "${PROJECT_SOURCE_DIR}/README.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)

# Manual pages and completion are what the program prints of its own options. CMake has no say in which pages there are.
set(npsee_manual "${PROJECT_BINARY_DIR}/manual")
add_custom_command(OUTPUT "${npsee_manual}/npsee.bash"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${npsee_manual}/man1"
  COMMAND npsee manual --pages "${npsee_manual}/man1" > "${npsee_manual}/pages.txt"
  COMMAND npsee manual --bash > "${npsee_manual}/npsee.bash"
  DEPENDS npsee COMMENT "Writing manual pages and completion" VERBATIM)
add_custom_target(npsee_manual_pages ALL DEPENDS "${npsee_manual}/npsee.bash")
install(DIRECTORY "${npsee_manual}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT program FILES_MATCHING PATTERN "*.1")
install(FILES "${npsee_manual}/npsee.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME npsee COMPONENT program)

set(CPACK_PACKAGE_NAME npsee)
set(CPACK_PACKAGE_VENDOR npsee)
set(CPACK_PACKAGE_CONTACT "npsee <npsee@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_INSTALL_DIRECTORY npsee)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Design explosion presets with sliders, fly artillery trajectories, run fire
missions, and render them to image files with or without a display. Contains
the simulator as a library for C++ and C.")
# What is linked is found by dpkg-shlibdeps; these are loaded at run time.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libosmesa6, libgl1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-inter, fonts-jetbrains-mono, libxrandr2, libxcursor1, libxi6")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, libexpected-dev, libclips-dev, libpng-dev")

set(CPACK_SOURCE_GENERATOR TXZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "npsee-${PROJECT_VERSION}")
set(CPACK_SOURCE_IGNORE_FILES "/\\.git(/|$)" "^${PROJECT_SOURCE_DIR}/build/" "^${PROJECT_SOURCE_DIR}/out/" "/\\.cache/" "__pycache__" "compile_commands\\.json$" "CMakeUserPresets\\.json$")
include(CPack)
