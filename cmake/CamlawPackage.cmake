# Debian packages by CPack, `./package deb`: camlaw, the program, libcamlaw-dev,
# to build against, and where there is an MPI camlaw-mpi, the plug-in with it. Run-time dependencies
# are what dpkg-shlibdeps finds.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR camlaw)
# A package names who answers for it; where this is empty, the field is taken out. (dpkg then warns.)
set(CAMLAW_MAINTAINER "" CACHE STRING "who answers for the Debian packages: Name <address>")
if(CAMLAW_MAINTAINER)
  set(CPACK_PACKAGE_CONTACT "${CAMLAW_MAINTAINER}")
else()
  set(CPACK_PACKAGE_CONTACT "nobody")  # CPack asks for one
  set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/without_maintainer.cmake)
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET camlaw_mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
endif()
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME camlaw)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "The program, for engineers of cam drives: motion
laws with exact peaks, cams, design optimisation with limits that hold over the whole cycle,
fronts, fits to measurements.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcamlaw-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and libraries, to build against:
motion laws and mechanisms generic in the scalar, the search for designs, problem files.")
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  libeigen3-dev libboost-dev libceres-dev libfmt-dev nlohmann-json3-dev libnlopt-dev
  coinor-libclp-dev coinor-libipopt-dev libsqlitecpp-dev libsqlite3-dev libtomlplusplus-dev
  libudunits2-dev)

# Whose worker program a program with several threads starts.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "camlaw (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_MPI_PACKAGE_NAME camlaw-mpi)
set(CPACK_DEBIAN_MPI_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "camlaw (= ${PROJECT_VERSION}), openmpi-bin")
set(CPACK_COMPONENT_MPI_DESCRIPTION "Plug-in of camlaw that shares the searches of fronts, sweeps
and tolerances out to the ranks of MPI: camlaw pareto --executor mpi.")

include(CPack)
