# Run by cpack on what it is about to pack: what Debian wants beside the files, and compressed.
foreach(of IN ITEMS program/usr/share/doc/epure library/usr/share/doc/libepure-dev)
  set(folder ${CPACK_TEMPORARY_DIRECTORY}/${of})
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/copyright ${CMAKE_CURRENT_LIST_DIR}/changelog DESTINATION ${folder}
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
    DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
file(REMOVE ${CPACK_TEMPORARY_DIRECTORY}/program/usr/share/doc/epure/LICENSE)  # it stands in copyright
file(GLOB_RECURSE files ${CPACK_TEMPORARY_DIRECTORY}/*/changelog ${CPACK_TEMPORARY_DIRECTORY}/*.1)
execute_process(COMMAND gzip -9n ${files} COMMAND_ERROR_IS_FATAL ANY)
