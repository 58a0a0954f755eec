# Runs when everything is installed: notes the files. CMAKE_INSTALL_MANIFEST_FILES has them without DESTDIR.
if(npsee_packing EQUAL -1)
  foreach(npsee_each IN LISTS CMAKE_INSTALL_MANIFEST_FILES)
    file(APPEND "${npsee_record}/files" "$ENV{DESTDIR}${npsee_each}\n")
  endforeach()
endif()
