# Kernels of the program, searched for their worst inputs. -frounding-math keeps the compiler from moving
# arithmetic of headers across a change of the rounding mode, or from doing it itself. The program is
# compiled without: its own files only assume that the mode does not change while a function runs.
add_library(kernels OBJECT
  kernels/all_kernels.cpp
  kernels/color_kernels.cpp
  kernels/doubt_kernels.cpp
  kernels/exact_kernels.cpp
  kernels/fill_kernels.cpp
  kernels/light_kernels.cpp
  kernels/model_kernels.cpp
  kernels/plane_kernels.cpp
  kernels/record_kernels.cpp
  kernels/region_kernels.cpp
  kernels/search.cpp
  kernels/specular_kernels.cpp
  kernels/texture_kernels.cpp
  kernels/trig_kernels.cpp
  kernels/view_kernels.cpp)
set_target_properties(kernels PROPERTIES UNITY_BUILD "${together}")
let_see(kernels tests)
target_link_libraries(kernels PUBLIC shading)
target_compile_options(kernels PUBLIC $<$<CONFIG:Release>:-O1> -fno-sanitize=undefined -frounding-math)
add_executable(search_kernels kernels/search_kernels.cpp)
target_link_libraries(search_kernels PRIVATE kernels)
add_executable(kernels_tests kernels/broken_test.cpp kernels/kernels_test.cpp)
target_link_libraries(kernels_tests PRIVATE kernels GTest::gtest GTest::gtest_main)
target_compile_definitions(kernels_tests PRIVATE
  XNEWELL_WORST_INPUTS="${CMAKE_CURRENT_SOURCE_DIR}/kernels/worst_inputs.txt")
gtest_discover_tests(kernels_tests DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
