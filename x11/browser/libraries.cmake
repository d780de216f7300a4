# What the build for browsers takes in place of the system's libraries. XNEWELL_LIBRARIES is a folder that build.sh
# fills: the sources of zlib and libpng, the headers of the others in `include`, and the font's table.
enable_language(C)
add_compile_options(-fwasm-exceptions -msimd128)
add_link_options(-fwasm-exceptions -sSUPPORT_LONGJMP=wasm -sALLOW_MEMORY_GROWTH -sSTACK_SIZE=8MB)

file(GLOB zlib ${XNEWELL_LIBRARIES}/zlib/*.c)
file(GLOB png ${XNEWELL_LIBRARIES}/libpng/png*.c)
list(FILTER zlib EXCLUDE REGEX "/gz[a-z]*\\.c$")
list(FILTER png EXCLUDE REGEX "/pngtest\\.c$")
add_library(png STATIC ${zlib} ${png})
target_include_directories(png SYSTEM PUBLIC ${XNEWELL_LIBRARIES}/zlib ${XNEWELL_LIBRARIES}/libpng)
target_compile_options(png PRIVATE -sSUPPORT_LONGJMP=wasm -w)
set_target_properties(png PROPERTIES UNITY_BUILD OFF)
add_library(PNG::PNG ALIAS png)

add_library(headers INTERFACE)
target_include_directories(headers SYSTEM INTERFACE ${XNEWELL_LIBRARIES}/include)
foreach(library glm::glm nlohmann_json::nlohmann_json CLI11::CLI11 X11::X11 X11::Xext Threads::Threads)
  add_library(${library} ALIAS headers)
endforeach()
