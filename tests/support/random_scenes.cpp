#include "tests/support/random_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace xnewell {

namespace {

constexpr int kLimit = 1 << 29, kDepthLimit = 1 << 30, kHalf = kGrid / 2;

int depthStep(double z) { return static_cast<int>(std::lrint(std::clamp(z, 0.0, double{kDepthLimit}))); }

/// The convex hull of points on the screen, counter-clockwise as seen and without corners of 180 degrees.
/// @see Andrew 1979, the monotone chain
std::vector<glm::ivec3> hull(std::vector<glm::ivec3> points) {
  std::ranges::sort(points, [](auto& a, auto& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<glm::ivec3> chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t begin = chain.size();
    for (const glm::ivec3& p : points) {
      while (chain.size() >= begin + 2) {
        const std::array corner{chain[chain.size() - 2], chain.back(), p};
        if (doubleArea(corner.data(), 3) > 0) break;
        chain.pop_back();
      }
      chain.push_back(p);
    }
    chain.pop_back();
    std::ranges::reverse(points);
  }
  return chain;
}

class Maker {
 public:
  Maker(unsigned seed, int count, int size) : rng_{seed}, count_{count}, size_{size} {}

  SnappedScene make(SceneKind kind) {
    for (int tries = 0; static_cast<int>(scene_.faces.size()) < count_ && tries < 100 * count_; ++tries)
      add(kind);
    return std::move(scene_);
  }

 private:
  using Points = std::vector<glm::ivec3>;

  int uniform(int low, int high) { return std::uniform_int_distribution{low, high}(rng_); }
  double uniform(double low, double high) { return std::uniform_real_distribution{low, high}(rng_); }
  bool oneIn(int n) { return uniform(1, n) == 1; }
  int anywhere() { return uniform(0, size_ * kGrid); }
  int centre() { return uniform(0, size_ - 1) * kGrid + kHalf; }

  template <class Vertex>
  void triangle(Vertex&& vertex) {
    const glm::ivec3 a = vertex(), b = vertex(), c = vertex();
    addFace(scene_, {a, b, c});
  }
  void add(SceneKind kind);
  void addStick();
  void addPinwheel();
  void addFan();
  void addPolygon(bool classes);

  std::mt19937 rng_;
  int count_, size_;
  SnappedScene scene_;
};

void Maker::add(SceneKind kind) {
  switch (kind) {
    case SceneKind::BigTriangles:
      return triangle([&] { return glm::ivec3{anywhere(), anywhere(), uniform(0, 1 << 24)}; });
    case SceneKind::Lattice:
      return triangle([&] {
        return glm::ivec3{uniform(0, 2 * size_) * kHalf, uniform(0, 2 * size_) * kHalf, uniform(0, 3)};
      });
    case SceneKind::Limits: {
      const auto across = [&] { return oneIn(3) ? (oneIn(2) ? kLimit : -kLimit) : uniform(-kLimit, kLimit); };
      const auto deep = [&] { return oneIn(3) ? (oneIn(2) ? 0 : kDepthLimit) : uniform(0, kDepthLimit); };
      return triangle([&] { return glm::ivec3{across(), across(), deep()}; });
    }
    case SceneKind::Slivers:
      return triangle([&] {
        return glm::ivec3{anywhere(), size_ * kHalf + uniform(-kGrid, kGrid), uniform(0, 1 << 20)};
      });
    case SceneKind::Sticks:
      return addStick();
    case SceneKind::Pinwheels:
      return addPinwheel();
    case SceneKind::NearCoplanar:
    case SceneKind::Coplanar:
      return triangle([&] {
        const int x = centre(), y = centre();
        return glm::ivec3{x, y,
                          (x + y) / 4 + (1 << 20) + (kind == SceneKind::NearCoplanar ? uniform(-1, 1) : 0)};
      });
    case SceneKind::Duplicates: {
      const int originals = 1 + count_ / 4;
      if (static_cast<int>(scene_.faces.size()) >= originals)
        return addCopy(scene_, uniform(0, originals - 1));
      return triangle([&] { return glm::ivec3{anywhere(), anywhere(), uniform(0, 1 << 22)}; });
    }
    case SceneKind::EqualZ: {
      const int z = uniform(0, 3) << 20;
      return triangle([&] { return glm::ivec3{anywhere(), centre(), z}; });
    }
    case SceneKind::Fans:
      return addFan();
    case SceneKind::SharedRow: {
      const int slope = uniform(-2, 2);
      return triangle([&] {
        const int row = uniform(0, size_);
        return glm::ivec3{anywhere(), row * kGrid + kHalf, (1 << 20) + slope * (row - size_ / 2)};
      });
    }
    case SceneKind::Tiny: {
      const int reach = 1 << uniform(1, 8), z = oneIn(2) ? 1 << 20 : uniform(0, kDepthLimit - 4096);
      const int x = uniform(0, 1) * kGrid + kHalf, y = uniform(0, 1) * kGrid + kHalf;
      return triangle([&] {
        return glm::ivec3{x + uniform(-reach, reach), y + uniform(-reach, reach), z + uniform(0, reach)};
      });
    }
    case SceneKind::Steep: {
      // a x - b y = 1 for coprime a and b: the points (0, 0), (b, a) and (y, x) span an area of one step.
      const int a = uniform(1, 1 << 21), b = uniform(1, 1 << 21);
      int x = 1, y = 0;
      for (int p = a, q = b, s = 0, t = 1; q != 0;) {
        const int whole = p / q;
        p = std::exchange(q, p - whole * q);
        x = std::exchange(s, x - whole * s);
        y = std::exchange(t, y - whole * t);
      }
      const glm::ivec3 at{centre() - b / 2, centre() - a / 2, 0};
      const int wide = uniform(0, 3);  // and a few similar ones, some hundred times as wide
      addFace(scene_,
              {at + glm::ivec3{0, 0, uniform(0, kDepthLimit)}, at + glm::ivec3{b, a, uniform(0, kDepthLimit)},
               at + glm::ivec3{-y + wide * 100, x, uniform(0, kDepthLimit)}});
      return;
    }
    case SceneKind::Polygons:
      return addPolygon(false);
    case SceneKind::Classes:
      return addPolygon(true);
  }
}

/// Adds a thin triangle between two points. Its third corner is a little beside one of them.
void Maker::addStick() {
  const int width = 1 << uniform(0, 17);
  const glm::ivec3 a{anywhere(), anywhere(), uniform(0, 1 << 22)},
      b{anywhere(), anywhere(), uniform(0, 1 << 22)};
  addFace(scene_,
          {a, b, b + glm::ivec3{uniform(-width, width), uniform(-width, width), uniform(0, 1 << 10)}});
}

/// Adds k blades along the sides of a polygon of k corners. Each begins far away and ends near, beyond the
/// corner where the next one begins.
void Maker::addPinwheel() {
  const int k = uniform(3, 6);
  const double radius = uniform(0.15, 0.5) * size_ * kGrid, turned = uniform(0.0, 6.3);
  const double x = anywhere(), y = anywhere(), rise = uniform(0, 1) ? 1 << 20 : 40,
               base = uniform(0, 3) * rise;
  const double clockwise = oneIn(2) ? -1.0 : 1.0;
  for (int i = 0; i < k; ++i) {
    const auto corner = [&](double along, double from) {
      const double angle = turned + clockwise * 2 * std::numbers::pi * along / k;
      return glm::dvec2{x + from * std::cos(angle), y + from * std::sin(angle)};
    };
    const glm::dvec2 from = corner(i, radius), to = corner(i + 1, radius), along = to - from;
    const glm::dvec2 tail = from - 0.4 * along, tip = to + 0.4 * along,
                     inner = tail + corner(i, -0.5 * radius) - glm::dvec2{x, y};
    const auto vertex = [&](const glm::dvec2& p, double z) {
      return glm::ivec3{std::lrint(p.x), std::lrint(p.y), depthStep(z)};
    };
    addFace(scene_, {vertex(tail, base), vertex(tip, base + rise), vertex(inner, base)});
  }
}

/// Adds triangles around a common vertex, from one rim point to the next. Some rims turn more than once.
void Maker::addFan() {
  const int k = uniform(3, 8);
  const glm::ivec3 apex{oneIn(2) ? centre() : anywhere(), oneIn(2) ? centre() : anywhere(),
                        uniform(0, 1 << 20)};
  const auto rim = [&] { return glm::ivec3{anywhere(), anywhere(), uniform(0, 1 << 20)}; };
  glm::ivec3 before = rim();
  for (int i = 0; i < k; ++i) {
    const glm::ivec3 point = rim();
    addFace(scene_, {apex, before, point});
    before = point;
  }
}

/// Adds a convex polygon of up to nine corners, or sometimes a triangle if `classes` is set. Its plane is its
/// own or, for classes, sometimes that of an earlier face. Its vertices are off the plane by a step here and
/// there, as the snap leaves them.
void Maker::addPolygon(bool classes) {
  const bool shared = classes && !scene_.planes.empty() && !oneIn(3);
  const int plane = shared ? uniform(0, static_cast<int>(scene_.planes.size()) - 1) : -1;
  const double slopeX = uniform(-8.0, 8.0), slopeY = uniform(-8.0, 8.0),
               base = uniform(0, 1) * (1 << 20) + (1 << 28);
  const double x = anywhere(), y = anywhere(), wide = uniform(1.0, 0.6 * size_) * kGrid,
               high = uniform(1.0, 0.6 * size_) * kGrid;
  const int corners = classes && oneIn(3) ? 3 : uniform(4, 9);
  Points points;
  for (int i = 0; i < corners; ++i) {
    const double angle = uniform(0.0, 2 * std::numbers::pi);
    glm::ivec3 p{std::lrint(x + wide * std::cos(angle)), std::lrint(y + high * std::sin(angle)), 0};
    if (oneIn(2)) p.x = p.x / kHalf * kHalf, p.y = p.y / kHalf * kHalf;
    const double z = shared ? depthAt(scene_.planes[plane], p.x, p.y)
                            : base + slopeX * (p.x - size_ * kHalf) + slopeY * (p.y - size_ * kHalf);
    p.z = depthStep(z + uniform(-1, 1));
    points.push_back(p);
  }
  addFace(scene_, hull(std::move(points)), plane);
}

}  // namespace

bool addFace(SnappedScene& scene, std::vector<glm::ivec3> outline, int plane) {
  const int count = static_cast<int>(outline.size());
  const std::int64_t area = count < 3 ? 0 : doubleArea(outline.data(), count);
  if (area == 0) return false;
  if (area < 0) std::ranges::reverse(outline);
  const bool isNew = plane < 0;
  if (!isNew)
    for (SnappedFace& face : scene.faces) face.throughVertices &= face.plane != plane;
  if (isNew) {
    plane = static_cast<int>(scene.planes.size());
    scene.planes.add(planeThrough(outline.data(), count));
  }
  scene.faces.push_back({static_cast<int>(scene.vertices.size()), count, static_cast<int>(scene.faces.size()),
                         0, false, count == 3 && isNew, plane});
  scene.vertices.insert(scene.vertices.end(), outline.begin(), outline.end());
  return true;
}

void addCopy(SnappedScene& scene, int face) {
  const SnappedFace& f = scene.faces[face];
  const auto first = scene.vertices.begin() + f.first;
  addFace(scene, {first, first + f.count});
}

SnappedScene randomScene(SceneKind kind, unsigned seed, int count, int size) {
  return Maker{seed, count, size}.make(kind);
}

}  // namespace xnewell
