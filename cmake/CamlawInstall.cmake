# What `cmake --install` puts where: the program with its man page and completions (component
# program), the plug-in with MPI (component mpi), and what other projects build against: headers,
# libraries, CMake's and pkg-config's descriptions (component development).

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(CAMLAW_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/camlaw)
set(CAMLAW_HEADER_DIR ${CMAKE_INSTALL_INCLUDEDIR}/camlaw)

# Under the folders that they have here, so that both trees are included from alike.
include(CamlawHeaders)
foreach(header IN LISTS CAMLAW_HEADERS)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION ${CAMLAW_HEADER_DIR}/${folder} COMPONENT development)
endforeach()

set(parts numerics kinematics optim machines problems fitting output)
# Each library is a part of the package of its own, so that who asks for kinematics needs no solver.
foreach(part IN LISTS parts)
  set_target_properties(camlaw_${part} PROPERTIES EXPORT_NAME ${part})
  target_include_directories(camlaw_${part} INTERFACE $<INSTALL_INTERFACE:${CAMLAW_HEADER_DIR}>)
  install(TARGETS camlaw_${part} EXPORT camlaw_${part}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT camlaw_${part} FILE camlaw_${part}.cmake NAMESPACE camlaw::
    DESTINATION ${CAMLAW_CMAKE_DIR} COMPONENT development)
endforeach()

configure_package_config_file(cmake/camlawConfig.cmake.in ${PROJECT_BINARY_DIR}/camlawConfig.cmake
  INSTALL_DESTINATION ${CAMLAW_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/camlawConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/camlawConfig.cmake ${PROJECT_BINARY_DIR}/camlawConfigVersion.cmake
  DESTINATION ${CAMLAW_CMAKE_DIR} COMPONENT development)
file(RELATIVE_PATH CAMLAW_PC_TO_PREFIX
  /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/camlaw.pc.in ${PROJECT_BINARY_DIR}/camlaw.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/camlaw.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

install(TARGETS camlaw RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS camlaw_worker
  RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/camlaw COMPONENT program)
if(CAMLAW_PAGMO)
  install(TARGETS camlaw_nsga2
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/camlaw COMPONENT program)
endif()
if(TARGET camlaw_step)
  install(TARGETS camlaw_step
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/camlaw COMPONENT program)
endif()
# By itself, as it needs the MPI of the machine, with its mpirun, which few have.
if(TARGET camlaw_mpi)
  install(TARGETS camlaw_mpi
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/camlaw COMPONENT mpi)
endif()
set(pages ${PROJECT_BINARY_DIR}/pages)
install(FILES ${pages}/camlaw.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${pages}/camlaw.bash RENAME camlaw COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
# Debian's zsh reads what packages bring in vendor-completions alone, others in site-functions.
foreach(folder site-functions vendor-completions)
  install(FILES ${pages}/camlaw.zsh RENAME _camlaw COMPONENT program
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder})
endforeach()
install(FILES ${pages}/camlaw.fish COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# The licence asks to go with every copy; this is where Debian's packages have theirs.
install(FILES LICENSE RENAME copyright COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/camlaw)
install(FILES LICENSE RENAME copyright COMPONENT development
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcamlaw-dev)
if(TARGET camlaw_mpi)
  install(FILES LICENSE RENAME copyright COMPONENT mpi
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/camlaw-mpi)
endif()

# The problem files with their tables, for `camlaw examples`; the program of the build folder finds
# those of the source folder by a link.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/problems DESTINATION ${CMAKE_INSTALL_DATADIR}/camlaw
  COMPONENT program
  FILES_MATCHING PATTERN "*.toml" PATTERN "*.csv"
  PATTERN baseline.csv EXCLUDE PATTERN fronts EXCLUDE PATTERN law_files EXCLUDE
  PATTERN published EXCLUDE PATTERN results EXCLUDE PATTERN statement EXCLUDE
  PATTERN cam_shape EXCLUDE PATTERN laws EXCLUDE)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/camlaw)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/problems ${PROJECT_BINARY_DIR}/share/camlaw/problems SYMBOLIC)
