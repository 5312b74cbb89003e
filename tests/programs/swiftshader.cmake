# The tests of images and rays once more on SwiftShader, a second driver that runs on the CPU: what holds on lavapipe
# alone shows itself here. Debian has it in the package chromium-common (tools/setup swiftshader), in a folder where no
# loader looks for drivers, so each test names it. Subgroups have 4 invocations there, work groups 256 at most,
# denormal numbers are zero, and it is four to five times slower than lavapipe.
find_file(LAVARAY_SWIFTSHADER_ICD vk_swiftshader_icd.json PATHS /usr/lib/chromium NO_DEFAULT_PATH
          DOC "SwiftShader's manifest for the Vulkan loader; without it there are no tests on SwiftShader")
if(NOT LAVARAY_SWIFTSHADER_ICD)
  # For ctest to name it among the tests that did not run.
  add_test(NAME swiftshader COMMAND ${CMAKE_COMMAND} -E false)
  set_tests_properties(swiftshader PROPERTIES DISABLED TRUE LABELS swiftshader)
  return()
endif()

# Beside the drivers that the loader finds: images are compared with lavapipe's.
set(on_swiftshader VK_ADD_DRIVER_FILES=${LAVARAY_SWIFTSHADER_ICD} LAVARAY_TEST_DEVICE=SwiftShader LAVARAY_STRESS=quick)

add_test(NAME swiftshader-against-lavapipe COMMAND driver_tests)
add_test(NAME swiftshader-conformance COMMAND conformance_tests)
# Left out is what tests statistics of samples rather than the device, with up to a million samples a pixel, and what
# is large: an image of 8192 x 8192 pixels, and a probe of more triangles than SwiftShader's texel buffers hold, 65,536
# texels. (The renderer reads larger scenes from storage buffers.)
add_test(NAME swiftshader-gpu COMMAND device_tests
         --gtest_filter=-Analytic.*:Convergence.*:Sampling.*:*Of8192By8192*:Traversal.SaysWhere*)
# Left out is what no device takes part in, and hundreds of pipelines: SwiftShader compiles for the better part of a
# second.
add_test(NAME swiftshader-stress COMMAND stress_tests
         --gtest_filter=-Bvh*:SpirvGate.*:HostileScenes.AreRefused*:AtAnyPlace.*:TurnedAboutTheAxis.*)
set(swiftshader_tests swiftshader-against-lavapipe swiftshader-conformance swiftshader-gpu swiftshader-stress)
set_tests_properties(${swiftshader_tests} PROPERTIES ENVIRONMENT "${on_swiftshader}")

# The programs' only device. A byte may differ by one; by more in a thousandth of the pixels, for edges (the test
# against lavapipe knows which pixels those are).
add_test(NAME swiftshader-validation-layer
         COMMAND lavaray --validate ${scenes}/showcase.txt --width 100
                 -o ${scratch}/swiftshader-validated.png)
list(APPEND swiftshader_programs swiftshader-validation-layer)
foreach(scene ${golden_scenes})
  lavaray_add_image_test(NAME swiftshader-golden-${scene} SCENE ${scenes}/${scene}.txt
                         REFERENCE ${golden}/${scene}.png OPTIONS --width 240 TOLERANCE 1 MAX_DIFFERING 38)
  list(APPEND swiftshader_programs swiftshader-golden-${scene})
endforeach()
set_tests_properties(${swiftshader_programs} PROPERTIES
                     ENVIRONMENT "VK_DRIVER_FILES=${LAVARAY_SWIFTSHADER_ICD};LAVARAY_UPDATE_REFERENCES=0")

set_tests_properties(${swiftshader_tests} ${swiftshader_programs} PROPERTIES LABELS swiftshader TIMEOUT 1200)
