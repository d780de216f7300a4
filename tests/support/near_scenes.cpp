#include "tests/support/near_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

using Pts = std::vector<glm::dvec3>;

class Maker {
 public:
  Maker(Near family, unsigned seed, int mostTiles)
      : family_{family}, rng_{seed * 7 + static_cast<unsigned>(family)}, seed_{seed}, mostTiles_{mostTiles} {}

  NearScene make() {
    static constexpr std::array kDecimals{4, 6, 5, 9, 3, 7, 17, 4, 8, 12, 6};
    decimals_ = kDecimals[seed_ % kDecimals.size()];
    unit_ = std::pow(10.0, -decimals_);
    scale_ = seed_ % 5 == 4 ? std::pow(10.0, -6 + static_cast<int>(seed_ / 5 % 13)) : 1.0;
    scene_.mesh.groupNames = {""};
    axes();
    static constexpr std::array kMade{&Maker::rugs,  &Maker::tiledWall, &Maker::sheets, &Maker::cards,
                                      &Maker::cycle, &Maker::triangles, &Maker::boxes};
    (this->*kMade[static_cast<std::size_t>(family_)])();
    if (0.5 * unit_ > 1.7e-5 * side()) triangulate();
    for (glm::dvec3& p : scene_.mesh.points) p *= scale_;
    scene_.u = 0.5 * unit_ * scale_;
    scene_.mesh.rounding = {scene_.u};
    scene_.camera.eye *= scale_, scene_.camera.lookAt *= scale_, scene_.camera.height *= scale_;
    return std::move(scene_);
  }

 private:
  [[nodiscard]] double side() const {
    glm::dvec3 low = scene_.mesh.points[0], high = low;
    for (const glm::dvec3& p : scene_.mesh.points) low = glm::min(low, p), high = glm::max(high, p);
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  }
  /// In a file this coarse, quadrilaterals are bent and planes are lost: the file is taken at its word.
  void triangulate() {
    const Mesh quads = std::exchange(scene_.mesh, Mesh{});
    scene_.mesh.points = quads.points;
    scene_.mesh.groupNames = quads.groupNames;
    for (int f = 0; f < quads.faceCount(); ++f)
      for (std::size_t k = 2; k < quads.face(f).size(); ++k)
        scene_.mesh.addFace(std::array{quads.face(f)[0], quads.face(f)[k - 1], quads.face(f)[k]}, 0);
    scene_.madeIn.assign(scene_.mesh.faceCount(), -1);
  }
  double in(double low, double high) { return std::uniform_real_distribution{low, high}(rng_); }
  /// A number between two others whose logarithm is uniform.
  double across(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v{in(-1, 1), in(-1, 1), in(-1, 1)};
      if (const double l = glm::length(v); l > 0.1 && l < 1.0) return v / l;
    }
  }
  /// Chooses the plane about which all is made: an axis or any.
  void axes() {
    N_ = in(0, 1) < 0.25 ? glm::dvec3{0, 1, 0} : direction();
    a_ = glm::normalize(glm::cross(N_, direction()));
    b_ = glm::cross(N_, a_);
    origin_ = in(0, 1) < 0.3 ? glm::dvec3{0} : in(0, 2) * direction();
  }
  glm::dvec3 at(double s, double t, double height = 0) const {
    return origin_ + s * a_ + t * b_ + height * N_;
  }

  void add(Pts corners, int madeIn = -1) {
    if (in(0, 1) < 0.5) std::reverse(corners.begin(), corners.end());
    std::vector<int> face;
    for (glm::dvec3 p : corners) {
      if (decimals_ < 16)
        for (int axis = 0; axis < 3; ++axis) p[axis] = std::nearbyint(p[axis] / unit_) * unit_;
      face.push_back(static_cast<int>(scene_.mesh.points.size()));
      scene_.mesh.points.push_back(p);
    }
    scene_.mesh.addFace(face, 0);
    scene_.madeIn.push_back(madeIn);
  }
  /// A turned rectangle about (s, t), on a plane through (s, t) that slopes by `slope`.
  Pts card(double s, double t, double angle, double length, double width, double height, double slope = 0,
           double slopeAt = 0) const {
    Pts corners;
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const double x = i * length / 2, y = j * width / 2;
      const double ds = x * std::cos(angle) - y * std::sin(angle),
                   dt = x * std::sin(angle) + y * std::cos(angle);
      corners.push_back(
          at(s + ds, t + dt, height + slope * (ds * std::cos(slopeAt) + dt * std::sin(slopeAt))));
    }
    return corners;
  }
  double turn() { return in(0, 2 * std::numbers::pi); }

  /// Looks at (s, t), from a height, at `distance` along the plane.
  void look(double s, double t, double distance, double height) {
    JudgedCamera& camera = scene_.camera;
    const double angle = turn();
    camera.lookAt = at(s, t);
    camera.eye =
        at(s + distance * std::cos(angle), t + distance * std::sin(angle), in(0, 1) < 0.5 ? height : -height);
    camera.up = glm::normalize(N_ + 0.3 * direction());
    const double away = glm::length(camera.eye - camera.lookAt);
    const double kind = in(0, 1);
    if (kind < 0.7) {
      camera.fov = in(20, 95);
    } else {
      camera.height = away * in(0.3, 1.5);
      if (kind > 0.85) camera.length = in(0.2, 1.2), camera.angle = in(0, 360);
    }
  }
  /// The least distance that keeps layers apart in the file: 2 |N|_1 of its units.
  double resolved() const { return 2 * (std::abs(N_.x) + std::abs(N_.y) + std::abs(N_.z)) * unit_; }

  void rugs() {
    const double side = across(1, 14);
    add(card(0, 0, turn(), side, side * in(0.4, 1), 0));
    const double gap = resolved() * across(1.02, 100);
    const int count = 1 + static_cast<int>(rng_() % 4);
    for (int k = 0; k < count; ++k)
      add(card(in(-0.2, 0.2) * side, in(-0.2, 0.2) * side, turn(), side * in(0.1, 0.6), side * in(0.1, 0.5),
               gap * (k + 1)));
    look(in(-0.2, 0.2) * side, in(-0.2, 0.2) * side, side * across(0.03, 1), side * across(0.01, 0.6));
  }
  void tiledWall() {
    const int n = static_cast<int>(across(10, mostTiles_ + 0.99));
    const double side = across(0.5, 20), tile = side / n;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double s = i * tile - side / 2, t = j * tile - side / 2;
        add({at(s, t), at(s + tile, t), at(s + tile, t + tile), at(s, t + tile)}, 0);
      }
    for (int k = 0; k < n * n; ++k) {
      const bool small = k >= 15;
      const double s = in(-0.45, 0.45) * side, t = in(-0.45, 0.45) * side;
      const double size = small ? tile * in(0.2, 1.5) : side * in(0.05, 0.3);
      add(card(k % 3 ? s : std::round(s / tile) * tile, k % 3 ? t : std::round(t / tile) * tile,
               k % 5 ? turn() : 0, size, size * in(0.3, 1), 0),
          0);
    }
    const bool close = seed_ % 3 == 0;
    look(in(-0.2, 0.2) * side, in(-0.2, 0.2) * side, side * (close ? across(0.02, 0.3) : in(0, 1)),
         side * (close ? across(0.005, 0.1) : in(0.3, 1.2)));
  }
  void sheets() {
    const int count = 3 + static_cast<int>(rng_() % 20);
    const double tilt = across(1e-6, 1e-2);
    for (int k = 0; k < count; ++k)
      add(card(in(-0.5, 0.5), in(-0.5, 0.5), turn(), in(0.3, 1.5), in(0.1, 1), in(-0.3, 0.3) * tilt,
               in(0, 1) * tilt, turn()));
    look(in(-0.3, 0.3), in(-0.3, 0.3), across(0.05, 2), across(0.05, 1.5));
  }
  void cards() {
    const double side = across(1, 14);
    const int count = 3 + static_cast<int>(rng_() % 8);
    add(card(0, 0, turn(), side, side, -side * in(0.05, 0.2)));
    const double gap = resolved() * across(1.01, 20);
    const bool rising = in(0, 1) < 0.5;
    for (int k = 0; k < count; ++k) {
      add(card(0, 0, 0.3 * k + in(0, 0.1), side * 0.12, side * in(0.05, 0.1),
               (rising ? k : count - k) * gap));
    }
    look(side * in(-0.03, 0.03), side * in(-0.03, 0.03), side * across(0.03, 0.3), side * across(0.03, 0.3));
  }
  void cycle() {
    const int count = 3 + static_cast<int>(rng_() % 4);
    const double gap = unit_ * across(0.3, 30), turned = turn();
    for (int k = 0; k < count; ++k) {
      const double angle = turned + k * 2 * std::numbers::pi / count;
      add(card(0.5 * std::cos(angle), 0.5 * std::sin(angle), angle + std::numbers::pi / 2, in(1.2, 2.4),
               in(0.3, 0.7), 0, gap, angle + std::numbers::pi / 2));
    }
    look(in(-0.2, 0.2), in(-0.2, 0.2), across(0.1, 2), across(0.3, 3));
  }
  void triangles() {
    const int count = 3 + static_cast<int>(rng_() % 12);
    const double thick = across(1e-6, 1e-3);
    for (int k = 0; k < count; ++k) {
      const double height = in(-1, 1) * thick;
      const auto corner = [&] {
        return at(in(-2, 2), in(-2, 2), height + (k % 3 ? 0.0 : in(-1, 1) * thick));
      };
      add({corner(), corner(), corner()});
    }
    look(in(-0.5, 0.5), in(-0.5, 0.5), across(0.05, 3), across(0.1, 2));
  }
  void boxes() {
    int plane = 0;
    add(card(0, 0, 0, 6, 6, 0), plane);
    for (int k = 0; k < 6; ++k) {
      const double s = in(-2, 2), t = in(-2, 2), angle = turn(), size = in(0.3, 1), height = in(0.2, 1);
      const Pts low = card(s, t, angle, size, size, 0), high = card(s, t, angle, size, size, height);
      add(high, ++plane);
      add(card(s, t, angle + 0.5, size / 2, size / 3, height), plane);
      for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        add({low[i], low[j], high[j], high[i]}, ++plane);
        const auto on = [&](double x, double y) {
          return low[i] + x * (low[j] - low[i]) + y * (high[i] - low[i]);
        };
        add({on(0.3, 0.2), on(0.8, 0.3), on(0.6, 0.9), on(0.2, 0.6)}, plane);
      }
      add(card(s, t, angle + 0.2, size * 1.3, size * 1.2, 0), 0);  // a rug under it
    }
    look(in(-2, 2), in(-2, 2), across(0.3, 8), across(0.3, 5));
    if (scene_.camera.height > 0) scene_.camera.height += 1;
  }

  Near family_;
  std::mt19937 rng_;
  unsigned seed_;
  int mostTiles_;
  int decimals_ = 6;
  double unit_ = 0, scale_ = 1;
  glm::dvec3 N_{0}, a_{0}, b_{0}, origin_{0};
  NearScene scene_;
};

}  // namespace

NearScene nearScene(Near family, unsigned seed, int mostTiles) {
  return Maker{family, seed, mostTiles}.make();
}

std::vector<std::uint32_t> shownFaces(const Mesh& mesh, const JudgedCamera& camera, int width, int height) {
  PictureCache pictures{makeScene("near", mesh, UpAxis::Y)};
  PictureSettings settings;
  settings.width = width;
  settings.height = height;
  settings.cull = Cull::Keep;
  CameraSettings given;
  given.eye = camera.eye, given.lookAt = camera.lookAt, given.up = camera.up;
  if (camera.height > 0) {
    given.parallel = true;
    given.height = camera.height;
    if (camera.length > 0) given.oblique = Oblique{camera.length, camera.angle};
  } else {
    given.fov = camera.fov;
  }
  settings.camera = given;
  return pictures.make(settings, 0).faceImage();
}

}  // namespace xnewell
