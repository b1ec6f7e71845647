# Run by CPack after it has made the Debian packages: takes the field Maintainer out of them.

foreach(package IN LISTS CPACK_PACKAGE_FILES)
  if(NOT package MATCHES "\\.deb$")
    continue()
  endif()
  set(folder ${package}.unpacked)
  file(REMOVE_RECURSE ${folder})
  execute_process(COMMAND dpkg-deb -R ${package} ${folder} COMMAND_ERROR_IS_FATAL ANY)
  file(STRINGS ${folder}/DEBIAN/control lines)
  list(FILTER lines EXCLUDE REGEX "^Maintainer:")
  list(JOIN lines "\n" control)
  file(WRITE ${folder}/DEBIAN/control "${control}\n")
  execute_process(COMMAND dpkg-deb --root-owner-group -b ${folder} ${package}
    OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${folder})
endforeach()
