# The rooms of the house, each a static library lavaray_ROOM of the folder host/ROOM. They are declared from the ground
# floor up: a room can link only rooms that are declared already, and include only headers of its own and of those that
# it links, by itself or through others. Where it does otherwise, configuring fails.

# lavaray_room(ROOM FILES file... [LINKS room...] [USES library...] [HIDES library...]): LINKS are the rooms below it
# that it needs; USES are other libraries of which its headers speak, HIDES those that stay inside.
function(lavaray_room room)
  cmake_parse_arguments(room "" "" "FILES;LINKS;USES;HIDES" ${ARGN})
  list(TRANSFORM room_FILES PREPEND ${PROJECT_SOURCE_DIR}/host/${room}/)
  add_library(lavaray_${room} STATIC ${room_FILES})
  target_include_directories(lavaray_${room} PUBLIC ${PROJECT_SOURCE_DIR}/host)
  target_link_libraries(lavaray_${room} PUBLIC lavaray_options ${room_USES} PRIVATE ${room_HIDES})
  set(reachable ${room})
  foreach(link ${room_LINKS})
    if(NOT TARGET lavaray_${link})
      message(FATAL_ERROR "host/${room} links ${link}, which is not a room below it")
    endif()
    target_link_libraries(lavaray_${room} PUBLIC lavaray_${link})
    get_property(below TARGET lavaray_${link} PROPERTY LAVARAY_REACHABLE_ROOMS)
    list(APPEND reachable ${below})
  endforeach()
  list(REMOVE_DUPLICATES reachable)
  set_property(TARGET lavaray_${room} PROPERTY LAVARAY_REACHABLE_ROOMS ${reachable})
  lavaray_check_includes(${room} "${reachable}")
endfunction()

# Fails where a file in host/FOLDER includes a header of a room that is not among ROOMS.
function(lavaray_check_includes folder rooms)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/${folder}/*.cpp ${PROJECT_SOURCE_DIR}/host/${folder}/*.hpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  foreach(file ${files})
    file(STRINGS ${file} includes REGEX "^#include \"[a-z_]+/")
    foreach(include ${includes})
      string(REGEX REPLACE "^#include \"([a-z_]+)/.*" "\\1" included "${include}")
      if(NOT included IN_LIST rooms)
        message(FATAL_ERROR "${file} says ${include}, but host/${folder} does not link ${included}; "
                            "it reaches: ${rooms}")
      endif()
    endforeach()
  endforeach()
endfunction()

# lavaray_program(NAME FOLDER FILES file... LINKS room...): a program of the files in host/FOLDER.
function(lavaray_program name folder)
  cmake_parse_arguments(program "" "" "FILES;LINKS" ${ARGN})
  list(TRANSFORM program_FILES PREPEND ${PROJECT_SOURCE_DIR}/host/${folder}/)
  add_executable(${name} ${program_FILES})
  set(reachable ${folder})
  foreach(link ${program_LINKS})
    target_link_libraries(${name} PRIVATE lavaray_${link})
    get_property(below TARGET lavaray_${link} PROPERTY LAVARAY_REACHABLE_ROOMS)
    list(APPEND reachable ${below})
  endforeach()
  lavaray_check_includes(${folder} "${reachable}")
  install(TARGETS ${name})
endfunction()
