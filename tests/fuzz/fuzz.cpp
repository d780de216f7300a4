#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "depthsort/depth_sort.h"
#include "geometry/files/bpt.h"
#include "geometry/files/model_file.h"
#include "geometry/files/obj.h"
#include "geometry/files/off.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/ply.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

// fuzz NAME CORPUS... [options of libFuzzer]: libFuzzer makes up bytes, and gives them to the row of kFuzzers
// that NAME chooses. A reader may refuse them as it would tell its user. The sanitizers and the assertions
// find what else it does.

namespace {

PictureSettings fewPixels(PictureSettings settings = {}) {
  settings.width = 40, settings.height = 30;
  return settings;
}

/// Scenes of more corners are read and not drawn: a fuzzer has no time for them.
constexpr std::size_t kMostCorners = 500;

/// Checks what mesh.h promises, and draws the model.
void drawFuzzed(Mesh mesh) {
  for (const int corner : mesh.corners)
    if (corner < 0 || corner >= std::ssize(mesh.points)) std::abort();
  for (const glm::dvec3& p : mesh.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) std::abort();
  if (mesh.corners.size() > kMostCorners) return;
  mesh.textureFiles.clear();
  for (MeshMaterial& m : mesh.materials) m.texture = -1;
  (void)makePicture(makeScene("fuzzed", std::move(mesh), UpAxis::Y), fewPixels(), std::uint8_t{8});
}

/// True if a text has a number of three digits or more after one of these keys, and so asks for a solid or
/// for patches of more polygons than a fuzzer has time for.
bool asksForMany(std::string_view text) {
  for (const std::string_view key : {"around", "down", "across", "divisions"})
    for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
      const std::size_t digit = text.find_first_of("0123456789", at);
      const std::size_t end = std::min(text.find_first_not_of("0123456789", digit), text.size());
      if (digit != text.npos && end - digit > 2) return true;
    }
  return false;
}

/// A scene of few corners is drawn with its own settings, but for its size.
void fuzzScene(std::string_view text) {
  if (asksForMany(text)) return;
  Scene scene = parseSceneFile(text, "s.json", dataFolder() / "scenes", 2);
  if (scene.mesh.corners.size() > kMostCorners) return;
  PictureSettings settings = fewPixels(scene.settings);
  settings.camera = scene.camera;
  (void)makePicture(std::move(scene), settings, std::uint8_t{8});
}

/// The set-up that a picture carries. The first byte says whether the others are a PNG file, or the text that
/// one carries: chance does not find the checksum of a chunk.
void fuzzSetup(std::string_view bytes) {
  static const std::string file =
      (std::filesystem::temp_directory_path() / ("xnewell-fuzz-" + std::to_string(getpid()) + ".png"))
          .string();
  if (bytes.empty()) return;
  const std::string rest{bytes.substr(1)};
  std::ofstream{file, std::ios::binary}
      << (bytes[0] % 2 == 0 ? rest : encodePng(IndexImage{3, 2, 7}, Palette{}, rest));
  const std::array<const char*, 5> words{"xnewell", "draw", file.c_str(), "-o", "no.png"};
  (void)parseOptions(static_cast<int>(words.size()), words.data());
}

/// Random polygons through snap, depth sort and painting. The first bytes choose the order and the view, then
/// come points with coordinates in eighths, then faces. Without contacts and voids, an exact order shows at
/// each sample the face that the oracle finds there.
void fuzzPolygons(std::string_view text) {
  constexpr int kPoints = 24, kMostFaces = 16;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  std::size_t size = text.size();
  if (size < 3 + 3 * kPoints + 3) return;
  PictureSettings settings = fewPixels();
  settings.order = bytes[0] % 2 == 0 ? Order::Newell : Order::Bsp;
  settings.shading = kShadings[bytes[1] % kShadings.size()].id;
  if (bytes[2] % 2 == 0) settings.camera.parallel = true;
  settings.cull = bytes[2] % 4 > 1 ? Cull::Back : Cull::Keep;
  bytes += 3, size -= 3;

  Mesh mesh;
  for (int i = 0; i < kPoints; ++i, bytes += 3, size -= 3)
    mesh.points.emplace_back(static_cast<std::int8_t>(bytes[0]) / 8.0,
                             static_cast<std::int8_t>(bytes[1]) / 8.0,
                             static_cast<std::int8_t>(bytes[2]) / 8.0);
  std::vector<int> face;
  while (size > 0 && mesh.faceCount() < kMostFaces) {
    const std::size_t corners = std::min<std::size_t>(3 + *bytes % 4, size - 1);
    face.clear();
    for (std::size_t k = 1; k <= corners; ++k) face.push_back(bytes[k] % kPoints);
    bytes += corners + 1, size -= corners + 1;
    if (corners >= 3) mesh.addFace(face, 0);
  }
  if (mesh.faceCount() == 0) return;
  mesh.groupNames = {"all"}, mesh.rounding = {0.0};
  PictureCache pictures{makeScene("fuzzed", std::move(mesh), UpAxis::Y)};
  const Picture picture = pictures.make(settings, std::uint8_t{8});
  const SortStatistics& sort = picture.sorted().statistics;
  if (sort.contacts > 0 || sort.voids > 0) return;
  const std::vector<std::uint32_t> shown = picture.faceImage();
  settings.order = Order::Oracle;
  if (pictures.make(settings, std::uint8_t{8}).faceImage() != shown) std::abort();
}

struct FuzzerRow {
  std::string_view name;
  void (*read)(std::string_view bytes);
};
constexpr std::array kFuzzers{
    FuzzerRow{"obj", [](auto text) { drawFuzzed(parseObj(text, "a.obj", "no such folder")); }},
    FuzzerRow{"mtl", [](auto text) { (void)parseMtl(text, "a.mtl"); }},
    FuzzerRow{"ply", [](auto text) { drawFuzzed(parsePly(text, "a.ply")); }},
    FuzzerRow{"off", [](auto text) { drawFuzzed(parseOff(text, "a.off")); }},
    FuzzerRow{"bpt", [](auto text) { drawFuzzed(tessellate(parseBpt(text, "a.bpt"), 2)); }},
    FuzzerRow{"scene", fuzzScene},
    FuzzerRow{"lesson",
              [](auto text) {
                if (!asksForMany(text)) (void)parseLesson(text, "l.json", dataFolder() / "lessons");
              }},
    FuzzerRow{"setup", fuzzSetup},
    FuzzerRow{"polygons", fuzzPolygons},
};
const FuzzerRow* chosenFuzzer = nullptr;

}  // namespace

}  // namespace xnewell

/// libFuzzer calls this at first. Takes NAME off the arguments.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace xnewell;
  const std::string_view name = *argc > 1 ? (*argv)[1] : "";
  const auto* const row = std::ranges::find(kFuzzers, name, &FuzzerRow::name);
  if (row == kFuzzers.end()) {
    std::cerr << "usage: fuzz NAME CORPUS... [options]\n";
    std::exit(2);
  }
  chosenFuzzer = row;
  std::swap((*argv)[0], (*argv)[1]);
  ++*argv, --*argc;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace xnewell;
  try {
    chosenFuzzer->read({reinterpret_cast<const char*>(bytes), size});
  } catch (const ParseError&) {
  } catch (const std::system_error&) {
  } catch (const ViewError&) {
  } catch (const UsageError&) {
  } catch (const TooManyPieces&) {
  }
  return 0;
}
