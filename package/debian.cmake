# Debian's packages, by cpack: epure, and libepure-dev for programs of one's own.
set(debian ${CMAKE_CURRENT_BINARY_DIR}/debian)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME epure)
set(CPACK_PACKAGE_VENDOR "the epure authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "graphical constructions of applied mechanics, exact and checked")
set(EPURE_PACKAGER "The epure authors <epure@epure.invalid>" CACHE STRING "Who makes Debian's packages: name, <address>")
set(CPACK_PACKAGE_CONTACT ${EPURE_PACKAGER})
string(REPLACE "-" "~" CPACK_PACKAGE_VERSION ${EPURE_VERSION})  # "1.0.0~rc" comes before 1.0.0
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME epure)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "epure carries out the graphical constructions of applied mechanics exactly
(instantaneous centres, polar diagrams of velocity and acceleration, polodes,
inflection circles, force polygons, involute gears), draws them to scale as
PDF and SVG, and checks every length measured on the sheet against a value
computed by an independent route.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libepure-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(needed libcgal-dev libboost-dev libeigen3-dev libgmp-dev libmpfr-dev libflint-dev)
if("flint-arb" IN_LIST flint_libraries)
  list(APPEND needed libflint-arb-dev libantic-dev libcalcium-dev)
endif()
list(JOIN needed ", " CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "The library that epure proves its numbers with: constructions, mechanisms and
closed formulas as templates over six numbers, from doubles by intervals and
balls to exact fields, and the climb from one to the next. Headers, a static
library, and what CMake and pkg-config need to find them.")

# What Debian wants beside the files, in both packages: the copyright, the changes.
set(debian_version ${CPACK_PACKAGE_VERSION})
set(debian_contact ${CPACK_PACKAGE_CONTACT})
configure_file(debian_changelog.in ${debian}/changelog @ONLY)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE mit)
file(READ ${PROJECT_SOURCE_DIR}/drawings/font/OFL.txt ofl)
foreach(text mit ofl)  # as the file's format has it: indented, a stop on an empty line
  string(STRIP "${${text}}" ${text})
  string(REGEX REPLACE "\n[ \t]*\n" "\n.\n" ${text} "${${text}}")
  string(REGEX REPLACE "\n[ \t]*\n" "\n.\n" ${text} "${${text}}")
  string(REPLACE "\n" "\n " ${text} "${${text}}")
endforeach()
configure_file(debian_copyright.in ${debian}/copyright @ONLY)
file(COPY_FILE ${CMAKE_CURRENT_SOURCE_DIR}/debian_files.cmake ${debian}/files.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${debian}/files.cmake)

include(CPack)
