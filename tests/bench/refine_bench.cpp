#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/view/scanline.h"
#include "shading/fill/evaluated.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/lit_floor.h"

namespace xnewell {

namespace {

/// The difference of a picture from per-pixel shading, in intensity.
struct Difference {
  double mean = 0, largest = 0;
};

/// Compares flat or Gouraud with Phong, sample by sample, before intensities are turned into cells.
Difference fromPhong(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  const SceneShading& shading = picture.shading();
  const Mesh& mesh = shading.mesh(picture.scene());
  const SnappedScene& snapped = picture.snapped();
  const std::vector<FrontBack<double>>& I = shading.intensities(0).I;
  Difference d;
  std::int64_t samples = 0;
  for (const SnappedFace& face : snapped.faces)
    forEachTriangle(snapped, face, [&](const FaceTriangle& t) {
      const PixelPlanes planes{t.p};
      PhongTriangle phong;
      phong.i0 = planes.i0(), phong.j0 = planes.j0();
      phong.lighting = &shading.lighting();
      phong.material = &shading.lighting().materials.front();
      phong.placed = true;
      phong.variesV = shading.lighting().variesV();
      std::array<double, 3> shown;
      std::array<glm::dvec3, 3> at;
      for (int k = 0; k < 3; ++k) {
        const int corner = snapped.source[t.vertex[k]];
        at[k] = mesh.points[mesh.corners[corner]];
        shown[k] =
            I[s.shading == Shading::Flat ? shading.pointOf(face) : shading.vertices().ofCorner[corner]].front;
      }
      for (int axis = 0; axis < 3; ++axis) {
        phong.at[axis] = planes({at[0][axis], at[1][axis], at[2][axis]});
        const double eye = shading.lighting().eye[axis];
        phong.V[axis] = planes({eye - at[0][axis], eye - at[1][axis], eye - at[2][axis]});
        phong.N[axis] = planes(axis == 2 ? std::array{1.0, 1.0, 1.0} : std::array{0.0, 0.0, 0.0});
      }
      const PixelPlane plane = planes(shown);
      forEachSpan(t.p.data(), 3, s.width, s.height, [&](int j, int from, int to) {
        for (int i = from; i < to; ++i) {
          const double value = plane.c + plane.gx * (i - planes.i0()) + plane.gy * (j - planes.j0());
          const double apart = std::abs(value - std::clamp(phong.intensity(i, j), 0.0, 1.0));
          d.mean += apart;
          d.largest = std::max(d.largest, apart);
          ++samples;
        }
      });
    });
  d.mean /= static_cast<double>(samples);
  return d;
}

/// Milliseconds of a frame, everything but the reading.
double frame(PictureCache& pictures, const PictureSettings& settings) {
  return pictures.make(settings, 0).times().total();
}

Scene spotFloor(int n) { return underSpot(floorOf(n)); }
Scene highlightFloor(int n) { return makeScene("floor", floorOf(n), UpAxis::Z); }

// A floor of n by n squares under a spotlight, or with a highlight, 480x480 from above. It is divided where
// the error is more than range / 1000. For comparison, polygons of one size, as many as there are parts:
// expect a larger difference, by the share of the floor that the rim or the highlight takes. Phong per pixel
// costs the same each frame, but the parts are kept until the light or the eye moves (again_ms: another
// window).
void BM_Refine(benchmark::State& state, Scene (*make)(int), int n, Shading shading) {
  const bool highlight = make == highlightFloor;
  const auto settingsOf = [&](Shading method) {
    const PictureSettings s = fromAbove(method);
    return highlight ? withHighlight(s) : s;
  };
  const Scene scene = make(n);
  PictureSettings settings = settingsOf(shading);
  settings.adapt = static_cast<double>(state.range(0)) / 1000.0;
  double ms = 0.0;
  PictureCache pictures{scene};
  for (auto _ : state) {
    pictures = PictureCache{scene};
    ms += frame(pictures, settings);
  }
  const int parts = pictures.last().snapped().polygons;
  const Difference d = fromPhong(pictures.last());
  state.counters["parts"] = parts;
  state.counters["mean"] = d.mean;
  state.counters["largest"] = d.largest;
  state.counters["frame_ms"] = ms / static_cast<double>(state.iterations());

  *settings.camera.height *= 1.01;
  state.counters["again_ms"] = frame(pictures, settings);

  settings = settingsOf(shading);
  const int triangles = shading == Shading::Flat ? 1 : 2;  // or polygons with which a square is shaded
  PictureCache even{make(std::max(n, static_cast<int>(std::lround(std::sqrt(double(parts) / triangles)))))};
  state.counters["even_ms"] = frame(even, settings);
  const Difference e = fromPhong(even.last());
  state.counters["even_parts"] = triangles * even.last().snapped().polygons;
  state.counters["even_mean"] = e.mean;
  state.counters["even_largest"] = e.largest;

  PictureCache phong{scene};
  state.counters["phong_ms"] = frame(phong, settingsOf(Shading::Phong));
}
#define REFINED(name, make, n, shading)                \
  BENCHMARK_CAPTURE(BM_Refine, name, make, n, shading) \
      ->Arg(0)                                         \
      ->Arg(100)                                       \
      ->Arg(30)                                        \
      ->Arg(10)                                        \
      ->Unit(benchmark::kMillisecond)
REFINED(spot, spotFloor, 8, Shading::Gouraud);
REFINED(highlight, highlightFloor, 1, Shading::Gouraud);
REFINED(spotFlat, spotFloor, 8, Shading::Flat);
REFINED(highlightFlat, highlightFloor, 1, Shading::Flat);

}  // namespace

}  // namespace xnewell
