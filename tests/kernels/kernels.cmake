# Kernels of the program, searched for their worst inputs. -frounding-math keeps the compiler from moving
# arithmetic of headers across a change of the rounding mode, or from doing it itself. The program is
# compiled without: its own files only assume that the mode does not change while a function runs.
add_executable(kernels_tests
  kernels/geometry_kernels.cpp kernels/kernels_test.cpp kernels/shading_kernels.cpp)
let_see(kernels_tests tests)
target_link_libraries(kernels_tests PRIVATE shading GTest::gtest GTest::gtest_main)
target_compile_options(kernels_tests PRIVATE
  $<$<CONFIG:Release>:-O1> -fno-sanitize=undefined -frounding-math)
target_compile_definitions(kernels_tests PRIVATE
  XNEWELL_WORST_INPUTS="${CMAKE_CURRENT_SOURCE_DIR}/kernels/worst_inputs.txt")
gtest_discover_tests(kernels_tests DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
