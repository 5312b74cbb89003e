# Why there is no device: the messages, with small drivers that fail in every way, loaded by the real Vulkan loader.
# Loaders answer differently (Debian 12's gives up over any manifest that is no JSON), so there may be others than this
# machine's, in folders that tools/unpack-drivers or tools/unpack-debian made.
file(GLOB unpacked_loaders ${PROJECT_BINARY_DIR}/loaders/*)
set(LAVARAY_LOADERS "" CACHE STRING "Folders of further Vulkan loaders, made by tools/unpack-debian")
list(APPEND LAVARAY_LOADERS ${unpacked_loaders})

find_package(VulkanHeaders REQUIRED)
add_library(faulty_driver MODULE faulty_driver.cpp)
add_library(needed_by_driver SHARED needed_by_driver.cpp)
add_library(needy_driver MODULE needy_driver.cpp)
add_library(failing_driver MODULE failing_driver.cpp)
target_link_libraries(faulty_driver PRIVATE lavaray_options Vulkan::Headers ${CMAKE_DL_LIBS})
target_link_libraries(failing_driver PRIVATE lavaray_options Vulkan::Headers ${CMAKE_DL_LIBS})
target_link_libraries(needed_by_driver PRIVATE lavaray_options)
target_link_libraries(needy_driver PRIVATE lavaray_options needed_by_driver)
# The test loads copies of them, far from what they need.
set_target_properties(failing_driver faulty_driver needed_by_driver needy_driver PROPERTIES SKIP_BUILD_RPATH ON
                      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/drivers)

# lavaray_no_device_test(NAME [FOLDER]): with the loader in FOLDER, or this machine's.
function(lavaray_no_device_test name)
  lavaray_program_test(${name} no_device_test.py ${programs} ${scenes} $<TARGET_FILE:faulty_driver>
                       $<TARGET_FILE:needy_driver> $<TARGET_FILE:needed_by_driver> ${scratch}/${name} ${ARGN})
endfunction()

lavaray_no_device_test(no-device)
# And where there is one, of which a function fails.
lavaray_program_test(failing-calls failing_calls_test.py ${programs} ${scenes} $<TARGET_FILE:failing_driver>
                     ${scratch}/failing-calls)
if(NOT LAVARAY_LOADERS)
  # For ctest to name it among the tests that did not run.
  add_test(NAME no-device-other-loaders COMMAND ${CMAKE_COMMAND} -E false)
  set_tests_properties(no-device-other-loaders PROPERTIES DISABLED TRUE LABELS programs)
endif()
foreach(folder ${LAVARAY_LOADERS})
  get_filename_component(name ${folder} NAME)
  lavaray_no_device_test(no-device-${name} ${folder})
endforeach()
