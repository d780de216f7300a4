# find_package(xnewell) gives the target xnewell::xnewell.
include(CMakeFindDependencyMacro)
find_dependency(PNG)
include(${CMAKE_CURRENT_LIST_DIR}/xnewellTargets.cmake)
