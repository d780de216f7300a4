# The program for browsers: the room of this folder stands in for what has Xlib.
target_compile_options(xnewell_options INTERFACE -include ${CMAKE_CURRENT_SOURCE_DIR}/browser/from_chars.h)
file(TOUCH ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
set_target_properties(x11_server PROPERTIES SOURCES ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
get_target_property(files x11_app SOURCES)
list(FILTER files EXCLUDE REGEX "(long_work|server|snapshot|viewer)\\.cpp$")
set_target_properties(x11_app PROPERTIES SOURCES "${files}")
room(browser USES x11_app FILES window.cpp)
target_link_libraries(xnewell PRIVATE x11_browser)

# For a page and for Node.
target_link_options(xnewell PRIVATE -sINVOKE_RUN=0 -sEXIT_RUNTIME=0 -lnodefs.js
  -sEXPORTED_RUNTIME_METHODS=FS,NODEFS,HEAPU8,UTF8ToString,callMain,ccall,ENV -sFORCE_FILESYSTEM
  --pre-js ${CMAKE_CURRENT_SOURCE_DIR}/browser/node.js
  --embed-file ${PROJECT_SOURCE_DIR}/data@/usr/share/xnewell
  "SHELL:--exclude-file */pictures" "SHELL:--exclude-file *.md")
