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
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR}/host APPEND PROPERTY LAVARAY_ROOMS lavaray_${room})
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

# lavaray_shared_library(): liblavaray, of the room `library`. Of all that is linked into it, only what that room marks
# LAVARAY_API can be seen. Programs link it as lavaray::lavaray.
function(lavaray_shared_library)
  add_library(liblavaray SHARED $<TARGET_OBJECTS:lavaray_library>)
  add_library(lavaray::lavaray ALIAS liblavaray)
  set_target_properties(liblavaray PROPERTIES OUTPUT_NAME lavaray EXPORT_NAME lavaray VERSION ${PROJECT_VERSION}
                                              SOVERSION ${PROJECT_VERSION_MAJOR})
  target_include_directories(liblavaray INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/host/library/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(liblavaray INTERFACE cxx_std_17)
  target_link_options(liblavaray PRIVATE LINKER:--exclude-libs,ALL LINKER:--no-undefined)
  target_link_libraries(liblavaray PRIVATE lavaray_library)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR}/host APPEND PROPERTY LAVARAY_ROOMS liblavaray)
endfunction()

# lavaray_client(NAME FOLDER FILES file... [LINKS room...]): a program of the files in host/FOLDER that is a client of
# liblavaray: it has its public headers, what the programs' command lines share, and rooms that stand on nothing.
function(lavaray_client name folder)
  cmake_parse_arguments(client "" "" "FILES;LINKS" ${ARGN})
  list(TRANSFORM client_FILES PREPEND ${PROJECT_SOURCE_DIR}/host/${folder}/)
  add_executable(${name} ${client_FILES})
  target_link_libraries(${name} PRIVATE lavaray_command_line liblavaray)
  foreach(link ${client_LINKS})
    get_property(below TARGET lavaray_${link} PROPERTY LAVARAY_REACHABLE_ROOMS)
    if(NOT below STREQUAL link)
      message(FATAL_ERROR "host/${folder} links ${link}, which stands on other rooms")
    endif()
    target_link_libraries(${name} PRIVATE lavaray_${link})
  endforeach()
  # A signal handler calls the library, which must be linked by then.
  target_link_options(${name} PRIVATE LINKER:-z,now)
  file(RELATIVE_PATH library /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/${library}")
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR}/host APPEND PROPERTY LAVARAY_ROOMS ${name})
  lavaray_check_includes(${folder} "${folder};command_line;${client_LINKS}")
  install(TARGETS ${name})
endfunction()

# Writes the drawing of the rooms and programs that are declared so far, from what their targets link, as a Mermaid
# diagram. docs/architecture.md holds it; a test compares.
function(lavaray_draw_rooms file)
  get_property(targets DIRECTORY PROPERTY LAVARAY_ROOMS)
  set(drawing "graph TD\n")
  foreach(target ${targets})
    string(REPLACE "lavaray_" "" name ${target})
    if(name MATCHES "-")
      # Mermaid's arrows are made of hyphens: such a name is a label only.
      string(REPLACE "-" "_" id ${name})
      string(APPEND drawing "  ${id}[${name}]\n")
      set(name ${id})
    endif()
    get_target_property(links ${target} LINK_LIBRARIES)
    foreach(link ${links})
      if(link IN_LIST targets OR link STREQUAL "lavaray_shaders")
        string(REPLACE "lavaray_" "" below ${link})
        string(APPEND drawing "  ${name} --> ${below}\n")
      endif()
    endforeach()
  endforeach()
  file(WRITE ${file} "${drawing}")
endfunction()
