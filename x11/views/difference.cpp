#include "x11/views/difference.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_precision.hpp>
#include <limits>

#include "depthsort/oracle.h"
#include "shading/color/color_difference.h"
#include "shading/color/quantize.h"

namespace xnewell {

namespace {

/// Adds up the differences, one sample after the other.
class Comparison {
 public:
  Comparison(Difference& difference, std::size_t samples) : difference_{difference} {
    difference.at.assign(samples, std::numeric_limits<float>::quiet_NaN());
  }
  void add(std::size_t sample, double by) {
    Difference& d = difference_;
    d.at[sample] = static_cast<float>(by);
    d.mean += (by - d.mean) / static_cast<double>(++d.samples);
    d.above += by > kMeasures[static_cast<int>(d.measure)].unit;
    if (by > d.largest) d.largest = by, d.largestAt = sample;
  }

 private:
  Difference& difference_;
};

Rgb16 stored(const glm::dvec3& intensities) {
  const auto channel = [](double v) { return static_cast<std::uint16_t>(std::floor(65535.0 * v + 0.5)); };
  return {channel(intensities.r), channel(intensities.g), channel(intensities.b)};
}

/// The settings of the reference, which keeps the picture's plan of colours.
PictureSettings referenceFor(const Scene& scene, PictureSettings settings) {
  settings.colors = planOf(scene, settings);
  settings.shading = Shading::Phong;
  settings.order = Order::Oracle;
  return settings;
}

/// The cells are the picture's: several hues share them by what a picture shows of each, so the reference's
/// own may be others.
void compareIntensities(Compared& result, const Picture& picture, const Picture& reference,
                        const SeenRows& seen) {
  const SceneColors& colors = picture.colors();
  const std::vector<double> I = reference.intensities(seen);
  const std::vector<Ramp> ramps = colors.ramps();
  Comparison comparison{result.difference, I.size()};
  for (std::size_t k = 0; k < I.size(); ++k) {
    if (seen.faces[k] == kNothing) continue;
    const SnappedFace& face = reference.snapped().faces[seen.faces[k]];
    result.reference.pixels[k] = ramps[reference.scene().mesh.material[face.number] + 1].cell(I[k]);
    comparison.add(k, std::abs(colors.intensityOf(picture.image().pixels[k]) - I[k]));
  }
}

void compareColors(Compared& result, const Picture& picture, const Picture& reference, const SeenRows& seen) {
  const Palette palette = picture.palette(CellPlan{picture.settings().table.kind});
  const std::array<std::vector<double>, 3> I{reference.intensities(seen, 0), reference.intensities(seen, 1),
                                             reference.intensities(seen, 2)};
  std::array<Lab, 256> ofCell;
  std::ranges::transform(palette, ofCell.begin(), [](const Rgb16& c) { return labFromSrgb(c); });
  Comparison comparison{result.difference, seen.faces.size()};
  RgbImage bytes{picture.image().width, picture.image().height};
  std::vector<std::uint8_t> shows(seen.faces.size(), 0);
  for (std::size_t k = 0; k < seen.faces.size(); ++k) {
    if (seen.faces[k] == kNothing) continue;
    shows[k] = 1;
    const Rgb16 color = stored({I[0][k], I[1][k], I[2][k]});
    bytes.rgb[3 * k] = static_cast<std::uint8_t>(color.r >> 8);
    bytes.rgb[3 * k + 1] = static_cast<std::uint8_t>(color.g >> 8);
    bytes.rgb[3 * k + 2] = static_cast<std::uint8_t>(color.b >> 8);
    comparison.add(k, ciede2000(ofCell[picture.image().pixels[k]], labFromSrgb(color)));
  }
  std::vector<glm::u8vec3> colors;
  const int first = reference.table().first();
  for (int c = first; c < first + kMaxShades; ++c)
    colors.emplace_back(palette[c].r >> 8, palette[c].g >> 8, palette[c].b >> 8);
  paintNearest(bytes, shows, colors, false, first, result.reference);
}

/// For each sample, the number of its face.
std::vector<int> faceNumbersOf(const Picture& picture, const SeenRows& seen) {
  std::vector<int> numbers(seen.faces.size(), kNothing);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (seen.faces[k] != kNothing) numbers[k] = picture.snapped().faces[seen.faces[k]].number;
  return numbers;
}

}  // namespace

Compared comparedWithPhong(const Picture& picture) {
  const PictureSettings& settings = picture.settings();
  const Picture reference = PictureCache{picture}.make(referenceFor(picture.scene(), settings));
  const SeenRows seen = reference.seen(0, settings.height);
  Compared result{{settings.width, settings.height, picture.ground()}, {}};
  result.difference.width = settings.width;
  if (channelsOf(reference.colors().plan()) == Channels::Rgb) {
    result.difference.measure = Measure::Color;
    compareColors(result, picture, reference, seen);
  } else {
    compareIntensities(result, picture, reference, seen);
  }
  const std::vector<int> shown = faceNumbersOf(picture, picture.seen(0, settings.height));
  const std::vector<int> numbers = faceNumbersOf(reference, seen);
  for (std::size_t k = 0; k < numbers.size(); ++k) result.difference.otherFace += shown[k] != numbers[k];
  return result;
}

}  // namespace xnewell
