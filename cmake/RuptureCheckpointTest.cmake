# rupture_add_checkpoint_test(NAME name PIPELINE program [argument...] GOLDEN file)
#
# A test of ctest that runs a pipeline in a fresh folder, with rupture's tools on its PATH, and
# compares the content checksums of the checkpoints and records (*.h5) that it writes there with the
# golden file. The program is a target of the project, a file (a relative name is one in the current
# source folder, as that of the golden file is), or a command on the PATH.
# The build target `rupture_regenerate_goldens` writes the golden files anew and keeps the old ones;
# tests that share a golden file are variants of one pipeline, of which the first is run for that.
# docs/regression-tests.md has an example.

function(rupture_add_checkpoint_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;GOLDEN" "PIPELINE")
  foreach(needed NAME PIPELINE GOLDEN)
    if(NOT test_${needed})
      message(FATAL_ERROR "rupture_add_checkpoint_test: ${needed} is missing; expected NAME, "
                          "PIPELINE and GOLDEN, each with a value.")
    endif()
  endforeach()
  if(test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "rupture_add_checkpoint_test: '${test_UNPARSED_ARGUMENTS}' is neither NAME, "
                        "PIPELINE nor GOLDEN.")
  endif()

  list(POP_FRONT test_PIPELINE program)
  if(TARGET ${program})
    set(program $<TARGET_FILE:${program}>)
  elseif(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${program})
    set(program ${CMAKE_CURRENT_SOURCE_DIR}/${program})
  endif()
  get_filename_component(golden ${test_GOLDEN} ABSOLUTE)
  set(arguments --tools ${rupture_TOOLS_DIR} --work ${CMAKE_CURRENT_BINARY_DIR}/${test_NAME}.files
                ${golden} ${program} ${test_PIPELINE})

  add_test(NAME ${test_NAME} COMMAND ${rupture_GOLDEN_PROGRAM} check ${arguments})
  set_tests_properties(${test_NAME} PROPERTIES SKIP_RETURN_CODE 77)

  get_property(goldens GLOBAL PROPERTY rupture_goldens)
  if(NOT golden IN_LIST goldens)
    set_property(GLOBAL APPEND PROPERTY rupture_goldens ${golden})
    add_custom_target(
      rupture_regenerate_${test_NAME}
      COMMAND ${rupture_GOLDEN_PROGRAM} regenerate ${arguments}
      COMMENT "Regenerating ${golden}"
      VERBATIM USES_TERMINAL)
    if(NOT TARGET rupture_regenerate_goldens)
      add_custom_target(rupture_regenerate_goldens)
    endif()
    add_dependencies(rupture_regenerate_goldens rupture_regenerate_${test_NAME})
  endif()
endfunction()
