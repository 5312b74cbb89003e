# Tests of pictures, for CTest. docs/testing-pictures.md is the manual.
#
# lavaray_add_image_test(NAME name SCENE file REFERENCE picture
#                        [OPTIONS option...] [TOLERANCE t] [MAX_DIFFERING n] [MAX_FLIP f] [LABELS label...])
#   Renders SCENE with lavaray's OPTIONS on a software driver and compares it with REFERENCE. It is skipped, with the
#   reason, where there is no such driver; OPTIONS with --device choose another device. Paths are relative to the
#   current source folder.
#
# lavaray_add_image_comparison(NAME name COMMAND command [argument...] IMAGE picture REFERENCE picture
#                              [TOLERANCE t] [MAX_DIFFERING n] [MAX_FLIP f] [LABELS label...])
#   Runs COMMAND, an executable target or a program, in the current binary folder, and compares the IMAGE that it writes,
#   relative to that folder, with REFERENCE.
#
# The limits are those of lavaray-diff; without any no pixel may differ. What fails is in the folder lavaray-pictures of
# the build: for each test its pictures, and for the whole run report.html. With LAVARAY_UPDATE_REFERENCES=1 in the
# environment a test that fails replaces its reference by what there is, and passes.

function(lavaray_add_image_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;SCENE;REFERENCE;TOLERANCE;MAX_DIFFERING;MAX_FLIP" "OPTIONS;LABELS")
  lavaray_check_picture_test(lavaray_add_image_test NAME SCENE REFERENCE)
  cmake_path(GET test_REFERENCE EXTENSION LAST_ONLY ending)
  if(NOT ending MATCHES "^\\.(bmp|png|ppm|pfm|exr)$")
    message(FATAL_ERROR "lavaray_add_image_test(${test_NAME}): REFERENCE ${test_REFERENCE} must end with what lavaray "
                        "writes: .bmp, .png, .ppm, .pfm or .exr")
  endif()
  if("${test_OPTIONS}" MATCHES "(^|;)(-o|--output)")
    message(FATAL_ERROR "lavaray_add_image_test(${test_NAME}): OPTIONS must not name the output")
  endif()
  cmake_path(ABSOLUTE_PATH test_SCENE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  get_property(program GLOBAL PROPERTY LAVARAY_PROGRAM)
  lavaray_add_picture_test(-DLAVARAY=${program} "-DSCENE=${test_SCENE}" RUN ${test_OPTIONS})
  set_tests_properties(${test_NAME} PROPERTIES SKIP_REGULAR_EXPRESSION "lavaray-pictures: skipped: ")
endfunction()

function(lavaray_add_image_comparison)
  cmake_parse_arguments(PARSE_ARGV 0 test "" "NAME;IMAGE;REFERENCE;TOLERANCE;MAX_DIFFERING;MAX_FLIP" "COMMAND;LABELS")
  lavaray_check_picture_test(lavaray_add_image_comparison NAME COMMAND IMAGE REFERENCE)
  list(POP_FRONT test_COMMAND program)
  if(TARGET ${program})
    set(program $<TARGET_FILE:${program}>)
  endif()
  cmake_path(ABSOLUTE_PATH test_IMAGE BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  cmake_path(ABSOLUTE_PATH test_REFERENCE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(test_IMAGE STREQUAL test_REFERENCE)
    message(FATAL_ERROR "lavaray_add_image_comparison(${test_NAME}): IMAGE and REFERENCE are the same file")
  endif()
  lavaray_add_picture_test("-DIMAGE=${test_IMAGE}" RUN ${program} ${test_COMMAND})
endfunction()

# What follows is not for others.

# Whether test_KEY of the caller is there for each key that is needed, and nothing that is not understood.
function(lavaray_check_picture_test function)
  foreach(key ${ARGN})
    if("${test_${key}}" STREQUAL "")
      message(FATAL_ERROR "${function}(${test_NAME}): ${key} is missing")
    endif()
  endforeach()
  if(test_UNPARSED_ARGUMENTS OR test_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "${function}(${test_NAME}): these are not understood, or have no value: "
                        "${test_UNPARSED_ARGUMENTS} ${test_KEYWORDS_MISSING_VALUES}")
  endif()
  foreach(limit TOLERANCE MAX_DIFFERING MAX_FLIP)
    if(NOT "${test_${limit}}" MATCHES "^([0-9]+\\.?[0-9]*|\\.[0-9]+)?$")
      message(FATAL_ERROR "${function}(${test_NAME}): ${limit} ${test_${limit}} is no number of 0 or more")
    endif()
  endforeach()
endfunction()

# lavaray_add_picture_test(definition... RUN argument...): the test of the caller's variables test_*. The definitions and
# arguments are for lavarayRunPictureTest.cmake.
function(lavaray_add_picture_test)
  cmake_parse_arguments(PARSE_ARGV 0 script "" "" "RUN")
  set(folder ${CMAKE_BINARY_DIR}/lavaray-pictures)
  set(runner ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/lavarayRunPictureTest.cmake)
  get_property(diff GLOBAL PROPERTY LAVARAY_DIFF_PROGRAM)
  set(common ${CMAKE_COMMAND} -DDIFF=${diff} "-DFOLDER=${folder}")
  cmake_path(ABSOLUTE_PATH test_REFERENCE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  add_test(NAME ${test_NAME}
           COMMAND ${common} -DSTEP=compare "-DNAME=${test_NAME}" "-DREFERENCE=${test_REFERENCE}"
                   "-DTOLERANCE=${test_TOLERANCE}" "-DMAX_DIFFERING=${test_MAX_DIFFERING}" "-DMAX_FLIP=${test_MAX_FLIP}"
                   ${script_UNPARSED_ARGUMENTS} -P ${runner} -- ${script_RUN}
           WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(${test_NAME} PROPERTIES LABELS "${test_LABELS}" FIXTURES_REQUIRED lavaray-pictures)
  # One page is made for all of a run: before its tests what the last run left is taken away, after them the page is
  # written.
  get_property(exists GLOBAL PROPERTY LAVARAY_PICTURES_FIXTURE)
  if(exists)
    return()
  endif()
  set_property(GLOBAL PROPERTY LAVARAY_PICTURES_FIXTURE TRUE)
  add_test(NAME lavaray-pictures-begin COMMAND ${common} -DSTEP=begin -P ${runner})
  add_test(NAME lavaray-pictures-report COMMAND ${common} -DSTEP=report -P ${runner})
  set_tests_properties(lavaray-pictures-begin PROPERTIES FIXTURES_SETUP lavaray-pictures)
  set_tests_properties(lavaray-pictures-report PROPERTIES FIXTURES_CLEANUP lavaray-pictures)
endfunction()
