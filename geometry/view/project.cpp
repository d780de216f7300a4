#include "geometry/view/project.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/view/clip.h"

namespace xnewell {

namespace {

/// Twice the area of a triangle.
std::int64_t doubleArea(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c) {
  const std::int64_t x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
  return y1 * x2 - x1 * y2;  // y runs down
}

/// Twice the area of an outline whose corners are at(k).
template <class At>
std::int64_t doubleAreaOf(int count, const At& at) {
  std::uint64_t sum = 0;
  for (int i = 1; i + 1 < count; ++i) sum += static_cast<std::uint64_t>(doubleArea(at(0), at(i), at(i + 1)));
  return static_cast<std::int64_t>(sum);
}

/// A vertex before the snap, in pixels: divided by w.
glm::dvec3 divided(const glm::dvec4& p) { return glm::dvec3{p} / p.w; }

/// The point of the clipped volume that is nearest to a vertex that clipping made. If an edge is vastly
/// longer than the picture, rounding may leave its end outside, or make it not a number.
glm::dvec3 inVolume(const glm::dvec3& p, double zFront) {
  const auto within = [](double x, double low, double high) { return std::fmax(low, std::fmin(x, high)); };
  return {within(p.x, -kMaxPicture, kMaxPicture), within(p.y, -kMaxPicture, kMaxPicture),
          within(p.z, 0.0, zFront)};
}

/// An outline with more corners is halved: comparing its corners would cost more than one more outline does.
constexpr int kMostCorners = 64;

/// A vertex of an outline with its SnappedScene::source.
struct ClippedCorner {
  glm::ivec3 at;
  int source;
};

/// The face, the part and the plane that an outline belongs to.
struct Owner {
  int number, part, plane;
};

/// Appends the snapped outlines of convex parts, one after the other. It reserves the room for all parts at
/// the start: growing for each would cost nearly as much as snapping them.
class Snapper {
 public:
  Snapper(SnappedScene& scene, const ConvexParts& parts, Cull cull, double zScale)
      : scene_{scene}, cull_{cull}, zScale_{zScale} {
    scene_.faces.reserve(parts.face.size());
    makeRoom(parts.corners.size());
  }

  [[nodiscard]] glm::ivec3 snap(const glm::dvec3& p) const { return snapToGrid(p, zScale_); }

  void add(std::vector<ClippedCorner>& outline, const Owner& owner) {
    dropRepeats(outline);
    const int count = static_cast<int>(outline.size());
    const std::int64_t area = count < 3 ? 0 : doubleAreaOf(count, [&](int k) { return outline[k].at; });
    if (area == 0) {
      ++scene_.degenerate;
      return;
    }
    const bool back = area < 0;
    if (back && cull_ == Cull::Back) {
      ++scene_.culled;
      return;
    }
    if (back) std::reverse(outline.begin(), outline.end());
    addConvex(outline.data(), count, owner, back);
  }

  /// Does the same for a triangle, the most frequent face, without a copy: `from` are its corners, and `at`
  /// are the indices of their snapped points. (Gathered in ClippedCorners, the values would be read back
  /// before their stores complete.)
  void addTriangle(const int* at, const int* from, const std::vector<glm::ivec3>& snapped,
                   const Owner& owner) {
    const glm::ivec3 &a = snapped[at[0]], &b = snapped[at[1]], &c = snapped[at[2]];
    const std::int64_t area = doubleArea(a, b, c);
    const bool back = area < 0;
    if (area == 0) {
      ++scene_.degenerate;
    } else if (back && cull_ == Cull::Back) {
      ++scene_.culled;
    } else {
      const std::size_t first = addFace(3, owner, back);
      scene_.faces.back().throughVertices = true;
      glm::ivec3* const vertex = &scene_.vertices[first];
      int* const source = &scene_.source[first];
      vertex[0] = back ? c : a, vertex[1] = b, vertex[2] = back ? a : c;
      source[0] = from[back ? 2 : 0], source[1] = from[1], source[2] = from[back ? 0 : 2];
    }
  }

  /// Frees the room that was not used.
  void finish() { makeRoom(vertices_); }

 private:
  /// Adds a face and returns the index of its first vertex. The caller must write the outline there.
  std::size_t addFace(int count, const Owner& owner, bool back) {
    const std::size_t first = vertices_;
    vertices_ += static_cast<std::size_t>(count);
    scene_.faces.push_back({.first = static_cast<int>(first),
                            .count = count,
                            .number = owner.number,
                            .part = owner.part,
                            .back = back,
                            .plane = owner.plane});
    if (vertices_ > scene_.vertices.size()) makeRoom(2 * vertices_);
    return first;
  }

  void append(const ClippedCorner* p, int count, const Owner& owner, bool back) {
    const std::size_t first = addFace(count, owner, back);
    for (int k = 0; k < count; ++k) {
      scene_.vertices[first + k] = p[k].at;
      scene_.source[first + k] = p[k].source;
    }
  }

  static void dropRepeats(std::vector<ClippedCorner>& outline) {
    const auto same = [](const ClippedCorner& a, const ClippedCorner& b) { return a.at == b.at; };
    outline.erase(std::unique(outline.begin(), outline.end(), same), outline.end());
    while (outline.size() > 1 && same(outline.front(), outline.back())) outline.pop_back();
  }

  static bool turnsBack(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c) {
    return std::int64_t{b.x - a.x} * (c.x - b.x) + std::int64_t{b.y - a.y} * (c.y - b.y) < 0;
  }

  static bool convex(const ClippedCorner* p, int count) {
    int descents = 0;  // a convex outline changes from rising to falling once per turn
    for (int i = 0; i < count; ++i) {
      const glm::ivec3 &a = p[i].at, &b = p[(i + 1) % count].at, &c = p[(i + 2) % count].at;
      const std::int64_t turn = doubleArea(a, b, c);
      if (turn < 0 || (turn == 0 && turnsBack(a, b, c))) return false;
      descents += (b.y > a.y || (b.y == a.y && b.x > a.x)) && !(c.y > b.y || (c.y == b.y && c.x > b.x));
    }
    return descents == 1;
  }

  /// Rounding may bend the outline of a polygon with many corners by a grid step, and pairs are compared
  /// corner by corner. So such an outline is halved along a chord between two of its own vertices, until the
  /// halves are convex (a triangle always is) and have few corners.
  void addConvex(const ClippedCorner* p, int count, const Owner& owner, bool back) {
    if (count == 3 || (count <= kMostCorners && convex(p, count))) {
      if (doubleAreaOf(count, [p](int k) { return p[k].at; }) <= 0)
        return;  // rounding turned this half over: it is less than a step wide
      append(p, count, owner, back);
      return;
    }
    const int half = count / 2;
    std::vector<ClippedCorner> rest{p + half, p + count};
    rest.push_back(p[0]);  // last, because chords from one vertex to all others would make needles
    addConvex(p, half + 1, owner, back);
    addConvex(rest.data(), static_cast<int>(rest.size()), owner, back);
  }

  void makeRoom(std::size_t vertices) {
    scene_.vertices.resize(vertices);
    scene_.source.resize(vertices);
  }

  SnappedScene& scene_;
  Cull cull_;
  double zScale_;
  std::size_t vertices_ = 0;  ///< number of vertices written
};

}  // namespace

std::int64_t doubleArea(const glm::ivec3* p, int count) {
  return doubleAreaOf(count, [p](int k) { return p[k]; });
}

SnappedScene snap(const Mesh& mesh, const ConvexParts& parts, const ViewSpec& view, int width, int height,
                  Cull cull) {
  const glm::dmat4 screenFromVrc = screenFromCanonical(view, width, height) * canonicalFromVrc(view);
  const glm::dmat3 rotation = vrcRotation(view);
  const double zFront = frontDepth(view, width);
  const std::array<ClipPlane, 6> planes = clipPlanes(zFront, kMaxPicture);

  // Transform every vertex. Divide those inside the volume by w; those outside are asked for once more.
  const auto homogeneous = [&](const glm::dvec3& point) {
    return screenFromVrc * glm::dvec4{rotation * (point - view.vrp), 1.0};
  };
  std::vector<glm::dvec3> screen(mesh.points.size());
  std::vector<std::uint8_t> outside(mesh.points.size());
  double zMax = 0.0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const glm::dvec4 p = homogeneous(mesh.points[i]);
    outside[i] = static_cast<std::uint8_t>(outcode(planes, p));
    if (outside[i]) continue;
    screen[i] = divided(p);
    zMax = std::max(zMax, screen[i].z);
  }

  // ConvexParts that cross a plane are clipped first: their new vertices count in the choice of the z scale.
  struct Clipped {
    int part, first, count;
  };
  SnappedScene scene;
  std::vector<Clipped> clipped;
  struct ClippedVertex {
    glm::dvec3 at;
    int source;
  };
  std::vector<ClippedVertex> clippedVertices;
  std::vector<ClipVertex> polygon;
  const int count = static_cast<int>(parts.face.size());
  scene.polygons = count;
  const bool allInside = std::ranges::all_of(outside, [](std::uint8_t code) { return code == 0; });
  for (int i = 0; i < count && !allInside; ++i) {
    unsigned any = 0, all = ~0u;
    for (const int corner : parts.part(i)) {
      any |= outside[corner];
      all &= outside[corner];
    }
    if (!any) continue;
    clipped.push_back({i, static_cast<int>(clippedVertices.size()), 0});
    if (all) continue;
    polygon.clear();
    for (int c = parts.firstCorner[i]; c < parts.firstCorner[i + 1]; ++c)
      polygon.push_back({homogeneous(mesh.points[parts.corners[c]]), parts.from[c]});
    clip(polygon, planes, any, scene.between);
    for (const ClipVertex& v : polygon) {
      clippedVertices.push_back({inVolume(divided(v.p), zFront), v.source});
      zMax = std::max(zMax, clippedVertices.back().at.z);
    }
    clipped.back().count = static_cast<int>(polygon.size());
  }

  // Snap everything once. A z step equals a step of x and y, unless a point comes too near for 30 bits.
  while (zMax * kGrid > std::ldexp(1.0, 30 + scene.zShift)) ++scene.zShift;
  Snapper snapper{scene, parts, cull, std::ldexp(1.0, kGridBits - scene.zShift)};
  std::vector<glm::ivec3> snapped(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (!outside[i]) snapped[i] = snapper.snap(screen[i]);

  std::vector<ClippedCorner> outline;
  auto next = clipped.begin();
  for (int i = 0; i < count; ++i) {
    outline.clear();
    if (next != clipped.end() && next->part == i) {
      for (int v = 0; v < next->count; ++v) {
        const ClippedVertex& vertex = clippedVertices[next->first + v];
        outline.push_back({snapper.snap(vertex.at), vertex.source});
      }
      ++next;
      if (outline.empty()) {
        ++scene.outside;
        continue;
      }
    } else {
      const int first = parts.firstCorner[i];
      if (parts.firstCorner[i + 1] == first + 3) {
        snapper.addTriangle(&parts.corners[first], &parts.from[first], snapped,
                            {parts.face[i], i, parts.plane[i]});
        continue;
      }
      for (int c = first; c < parts.firstCorner[i + 1]; ++c)
        outline.push_back({snapped[parts.corners[c]], parts.from[c]});
    }
    snapper.add(outline, {parts.face[i], i, parts.plane[i]});
  }
  snapper.finish();
  return scene;
}

}  // namespace xnewell
