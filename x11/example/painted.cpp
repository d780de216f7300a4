/// painted MODEL.obj PICTURE.png: draws a model, and prints its polygons in painting order, back to front.
/// Each line is a face, or a part of one, and its corners on the screen:
///   {"face": 17, "piece": [[403.5, 120.25], [410.0, 131.5], [398.75, 129.0]]}

#include <xnewell.h>

#include <cstdio>
#include <exception>

using namespace xnewell::library;

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fputs("usage: painted MODEL.obj PICTURE.png\n", stderr);
    return 2;
  }
  const View view{.width = 400, .height = 300};
  for (const Piece& piece : paintingOrder(readObj(argv[1]), view)) {
    std::printf("{\"face\": %d, \"piece\": [", piece.face);
    const char* between = "";
    for (const auto& [x, y] : piece.outline) {
      std::printf("%s[%.17g, %.17g]", between, x, y);
      between = ", ";
    }
    std::puts("]}");
  }
  writePng(argv[2], draw(argv[1], view));
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "painted: %s\n", e.what());
  return 1;
}
