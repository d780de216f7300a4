#include "x11/homework/diagnosis_sheet.h"

#include <algorithm>
#include <array>

#include "shading/color/png.h"
#include "x11/drawing/painter.h"
#include "x11/homework/diagnosis_report.h"

namespace xnewell {

namespace {

constexpr int kSheetGap = 8, kSheetHead = 24;
constexpr std::array<std::uint8_t, 3> kFrame{255, 220, 0};

/// Copies a picture to (x, kSheetHead).
void placeOn(RgbImage& sheet, const RgbImage& picture, int x) {
  for (int j = 0; j < picture.height; ++j)
    std::copy_n(picture.pixel(0, j), std::size_t{3} * picture.width, sheet.pixel(x, kSheetHead + j));
}

/// Writes a title above a picture, in white.
void writeOn(RgbImage& sheet, int x, int width, const std::string& text) {
  IndexImage strip{width, kSheetHead, 0};
  Painter{strip}.text(4, 16, beginningOf(text, width - 8), 1);
  for (int j = 0; j < strip.height; ++j)
    for (int i = 0; i < width; ++i)
      if (strip.row(j)[i] != 0) std::fill_n(sheet.pixel(x + i, j), 3, std::uint8_t{255});
}

/// A frame around [low, high], three pixels outside of it.
void frameOn(RgbImage& sheet, int x, int width, int height, std::array<int, 4> box) {
  const int left = std::max(0, box[0] - 3), top = std::max(0, box[1] - 3);
  const int right = std::min(width - 1, box[2] + 3), bottom = std::min(height - 1, box[3] + 3);
  const auto dot = [&](int i, int j) { std::ranges::copy(kFrame, sheet.pixel(x + i, kSheetHead + j)); };
  for (int i = left; i <= right; ++i) dot(i, top), dot(i, bottom);
  for (int j = top; j <= bottom; ++j) dot(left, j), dot(right, j);
}

}  // namespace

std::string diagnosisSheet(Diagnoser& diagnoser, const HandedIn& handed, const Diagnosis& d) {
  const PictureSettings& settings = diagnoser.picture().settings();
  const int w = settings.width, h = settings.height;
  const Hypothesis& right = hypotheses().front();
  const bool named = !d.found.empty();
  std::vector<std::pair<std::string, RgbImage>> pictures{
      {"yours", handed.picture}, {"right", diagnoser.pictureBy(diagnoser.approachWith(right))}};
  if (named && d.found.front().first != &right)
    pictures.emplace_back("with " + nameOf(d.found.front()),
                          diagnoser.pictureBy(diagnoser.approachOf(d.found.front())));
  std::array<int, 4> box{w, h, -1, -1};
  if (d.pixel) {
    const SnappedScene& scene = diagnoser.picture().snapped();
    box = {d.pixel->i, d.pixel->j, d.pixel->i, d.pixel->j};
    for (const SnappedFace& face : scene.faces)
      for (int k = 0; k < face.count && face.number == d.pixel->face; ++k) {
        const glm::ivec3 p = scene.vertices[face.first + k] / kGrid;
        box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x), std::max(box[3], p.y)};
      }
  }
  int width = 0, height = 0;
  for (const auto& [name, picture] : pictures)
    width += picture.width + kSheetGap, height = std::max(height, picture.height);
  RgbImage sheet{width - kSheetGap, height + kSheetHead};
  int x = 0;
  for (const auto& [name, picture] : pictures) {
    placeOn(sheet, picture, x);
    writeOn(sheet, x, picture.width, name);
    if (d.pixel && picture.width == w && picture.height == h) frameOn(sheet, x, w, h, box);
    x += picture.width + kSheetGap;
  }
  return encodePng(sheet);
}

}  // namespace xnewell
