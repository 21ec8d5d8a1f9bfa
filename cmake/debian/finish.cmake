# Run by CPack on the installed tree before it is packed: what Debian's policy asks for beyond an installation.
set(root ${CPACK_TEMPORARY_DIRECTORY})
if(NOT IS_DIRECTORY ${root}/usr)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
endif()
set(documents ${root}/usr/share/doc/ringwatch)
configure_file(${CPACK_RINGWATCH_SOURCE_DIR}/cmake/debian/copyright ${documents}/copyright COPYONLY)
configure_file(${CPACK_RINGWATCH_SOURCE_DIR}/CHANGELOG.md ${documents}/NEWS COPYONLY)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH sets it
file(WRITE ${documents}/changelog "ringwatch (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * What is new is in NEWS.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
# Programs that ringwatch starts are explained where ringwatch is.
foreach(program ringwatch-verify ringwatch-report ringwatch-ranks)
  if(EXISTS ${root}/usr/bin/${program})
    file(WRITE ${root}/usr/share/man/man1/${program}.1 ".so man1/ringwatch.1\n")
  endif()
endforeach()
if(EXISTS ${root}/usr/bin/ringwatch-check)
  configure_file(${CPACK_RINGWATCH_SOURCE_DIR}/cmake/debian/ringwatch-check.1 ${root}/usr/share/man/man1/ringwatch-check.1 COPYONLY)
endif()
# Site folders are the administrator's.
if(IS_DIRECTORY ${root}/usr/share/zsh/site-functions)
  file(RENAME ${root}/usr/share/zsh/site-functions ${root}/usr/share/zsh/vendor-completions)
endif()
file(GLOB_RECURSE headers_folders LIST_DIRECTORIES true ${root}/usr/include/*)
foreach(folder IN LISTS headers_folders)
  if(IS_DIRECTORY ${folder})
    file(GLOB inside ${folder}/*)
    if(NOT inside)
      file(REMOVE_RECURSE ${folder})
    endif()
  endif()
endforeach()
file(GLOB pages ${root}/usr/share/man/man1/*.1)
execute_process(COMMAND gzip -9n ${pages} ${documents}/changelog ${documents}/NEWS COMMAND_ERROR_IS_FATAL ANY)
file(GLOB archives ${root}/usr/lib/*.a ${root}/usr/lib/*/*.a)
if(archives)
  execute_process(COMMAND strip --strip-debug --enable-deterministic-archives ${archives} COMMAND_ERROR_IS_FATAL ANY)
endif()
file(GLOB programs ${root}/usr/bin/*)
execute_process(COMMAND strip --remove-section=.comment --remove-section=.note ${programs} COMMAND_ERROR_IS_FATAL ANY)
file(CHMOD_RECURSE ${documents} ${root}/usr/share/man FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
  DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
