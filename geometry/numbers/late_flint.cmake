# load_flint_late(PROGRAM LIBRARIES...): the program loads FLINT when it first needs it, see late_flint.c. LIBRARIES are
# those of ours that call it. Only where late_flint.c knows the processor, and not under the sanitisers, which want to
# see all libraries from the start: elsewhere FLINT is linked as anything else is.
function(load_flint_late program)
  if(EPURE_SANITIZE OR NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    return()
  endif()
  # The first of the libraries brings the others. It is loaded by the name that a program linked with it would ask for.
  set(files "")
  foreach(library IN LISTS flint_libraries)
    find_library(FLINT_FILE_${library} ${library} REQUIRED)
    list(APPEND files ${FLINT_FILE_${library}})
  endforeach()
  list(GET files 0 first)
  execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${first} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  if(NOT said MATCHES "SONAME +([^ \n]+)")
    message(FATAL_ERROR "${first} does not say its name")
  endif()
  set(name ${CMAKE_MATCH_1})

  set(here ${PROJECT_SOURCE_DIR}/geometry/numbers)
  set(names ${CMAKE_CURRENT_BINARY_DIR}/${program}-late/names.inc)
  set(ours ${ARGN})
  list(TRANSFORM ours REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  add_custom_command(OUTPUT ${names} VERBATIM
    COMMAND sh ${here}/list_flint_names.sh ${CMAKE_NM} ${names} ${files} -- ${ours}
    DEPENDS ${here}/list_flint_names.sh ${ARGN})
  add_library(${program}_late_flint OBJECT ${here}/late_flint.c ${names})
  target_include_directories(${program}_late_flint PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${program}-late)
  target_compile_definitions(${program}_late_flint PRIVATE EPURE_FLINT="${name}")
  target_link_libraries(${program}_late_flint PRIVATE epure_settings)
  set_target_properties(${program} PROPERTIES LATE_FLINT ON)
  target_link_libraries(${program} PRIVATE ${program}_late_flint)
endfunction()
