#include "depthsort/region.h"
#include "tests/kernels/grid_triangles.h"

namespace xnewell {

namespace {

/// The scene of some triangles, one plane each.
SnappedScene sceneOf(const Numbers& in) {
  SnappedScene scene;
  for (std::size_t k = 0; k + 9 <= in.size(); k += 9) {
    const Triangle t = triangleAt(&in[k]);
    scene.faces.push_back({.first = static_cast<int>(scene.vertices.size()),
                           .count = 3,
                           .number = static_cast<int>(k / 9),
                           .part = 0,
                           .back = false,
                           .plane = static_cast<int>(k / 9)});
    scene.vertices.insert(scene.vertices.end(), t.begin(), t.end());
    scene.planes.add(planeOf(t));
  }
  scene.source.resize(scene.vertices.size());
  return scene;
}

/// a, b, c of a cut line. The larger of |a|, |b| is scaled to 1, so the exact line is scaled by its own.
Kernel cutLineKernel() {
  return {.name = "meeting line of two planes",
          .claim = "6 2^-53 of each coefficient",
          .header = "depthsort/region.h",
          .input = triangles(2),
          .prepare = [](const Numbers& in) { return turned(in, 2); },
          .run =
              [](const Numbers& in) {
                const SnappedScene scene = sceneOf(in);
                const Line line = Regions{scene}.cut(0, 1);
                return Numbers{line.a, line.b, line.c};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const WholeLine l =
                    difference(ExactPlane{triangleAt(in.data())}, ExactPlane{triangleAt(&in[9])});
                const Big a{l.a}, b{l.b}, c{l.c}, most = largerOf(abs(a), abs(b));
                if (most == 0) {  // parallel: c has the sign everywhere
                  const int sign = (out[2] > 0) - (out[2] < 0);
                  return out[0] == 0 && out[1] == 0 && sign == l.c.sign() ? 0.0 : kWrong;
                }
                double worst = 0;
                const std::array exact{Big{a / most}, Big{b / most}, Big{c / most}};
                for (int k = 0; k < 3; ++k)
                  worst = std::max(worst, shareOf(out[k], exact[k], 6 * kU * abs(exact[k])));
                return worst;
              },
          .hard = {[](Random& random) {
            Numbers in;
            addTriangle(in, random);
            random.oneIn(2) ? addTriangle(in, random) : addNearlyCoplanar(in, 0, random);
            if (random.oneIn(3)) in.clear(), addCoplanar(in, random);
            return in;
          }}};
}

/// The exact side of a region: the edge of a face from vertex p to q, or a cut.
WholeLine exactly(const Numbers& in, const Line& line) {
  if (line.kind == Line::Kind::Cut)
    return difference(ExactPlane{triangleAt(&in[9 * line.p])}, ExactPlane{triangleAt(&in[9 * line.q])});
  const auto vertex = [&](int k) { return std::array{Whole{in[3 * k]}, Whole{in[3 * k + 1]}}; };
  const auto p = vertex(line.p), q = vertex(line.q);
  const Whole a = q[1] - p[1], b = p[0] - q[0];
  return {a, b, -(a * p[0] + b * p[1])};
}

/// A face is cut by the meeting lines with two others. The corners must be within their radius of the exact
/// ones, and a third line must have the exact sign at each. In an input: face, three others.
Kernel cutKernel() {
  const auto sides = [](const Numbers& in, const Numbers& out) {
    // Sides come as kind, p, q, x, y, radius, sign.
    std::vector<Line> lines;
    for (std::size_t k = 0; k < out.size(); k += 7)
      lines.push_back(
          {static_cast<Line::Kind>(out[k]), static_cast<int>(out[k + 1]), static_cast<int>(out[k + 2])});
    std::vector<WholeLine> exact;
    for (const Line& line : lines) exact.push_back(exactly(in, line));
    return exact;
  };
  return {
      .name = "cut of a face and classification",
      .claim = "exact; a corner is within its radius",
      .header = "depthsort/region.h",
      .input = triangles(4),
      .prepare = [](const Numbers& in) { return turned(in, 4); },
      .run =
          [](const Numbers& in) {
            const SnappedScene scene = sceneOf(in);
            const Regions regions{scene};
            Region region;
            regions.outline(scene.faces[0], region);
            for (int k = 1; k <= 2 && !region.empty(); ++k)
              if (!regions.samePlane(0, k)) regions.clip(region, regions.cut(0, k));
            Numbers out;
            if (regions.samePlane(0, 3)) return out;
            const Line third = regions.cut(0, 3);
            for (std::size_t k = 0; k < region.size(); ++k) {
              const Line& next = region[(k + 1) % region.size()].line;
              const auto& [line, corner] = region[k];
              out.insert(out.end(),
                         {double(static_cast<int>(line.kind)), double(line.p), double(line.q), corner.x,
                          corner.y, corner.radius, double(regions.sign(third, line, next, corner))});
            }
            return out;
          },
      .judge =
          [sides](const Numbers& in, const Numbers& out) {
            const std::vector<WholeLine> lines = sides(in, out);
            const WholeLine third =
                difference(ExactPlane{triangleAt(in.data())}, ExactPlane{triangleAt(&in[27])});
            double worst = 0;
            for (std::size_t k = 0; k < lines.size(); ++k) {
              const WholeLine &l = lines[k], &m = lines[(k + 1) % lines.size()];
              const Whole X = l.b * m.c - m.b * l.c, Y = m.a * l.c - l.a * m.c, W = l.a * m.b - m.a * l.b;
              if (W == 0) return kWrong;
              const Whole value = third.a * X + third.b * Y + third.c * W;
              if (value.sign() * W.sign() != static_cast<int>(out[7 * k + 6])) return kWrong;
              const Big radius = big(out[7 * k + 5]);
              worst = std::max({worst, shareOf(out[7 * k + 3], Big{X} / Big{W}, radius),
                                shareOf(out[7 * k + 4], Big{Y} / Big{W}, radius)});
              // Every corner lies on the inner side of every line.
              for (const WholeLine& other : lines) {
                const Whole side = other.a * X + other.b * Y + other.c * W;
                if (side.sign() * W.sign() < 0) return kWrong;
              }
            }
            return worst;
          },
      .hard = {[](Random& random) {  // two pairs of triangles in one plane
                 Numbers in;
                 addCoplanar(in, random);
                 addCoplanar(in, random);
                 if (random.oneIn(2)) std::swap_ranges(in.begin() + 9, in.begin() + 18, in.begin() + 18);
                 return in;
               },
               [](Random& random) {
                 Numbers in;
                 addTriangle(in, random);
                 for (int k = 0; k < 3; ++k)
                   random.oneIn(2) ? addTriangle(in, random) : addNearlyCoplanar(in, 0, random);
                 return in;
               },
               [](Random& random) {  // the others are nearly in one plane: their lines are nearly parallel
                 Numbers in;
                 addTriangle(in, random);
                 addTriangle(in, random);
                 addNearlyCoplanar(in, 9, random);
                 addNearlyCoplanar(in, 9, random);
                 return in;
               }},
      .directed = 1,
      .effort = 0.5};
}

}  // namespace

void addRegionKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(cutLineKernel());
  kernels.push_back(cutKernel());
}

}  // namespace xnewell
