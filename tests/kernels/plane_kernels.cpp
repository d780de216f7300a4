#include "depthsort/region.h"
#include "geometry/view/screen_plane.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

constexpr double kU = 0x1p-53;
constexpr double kReach = 0x1p29, kDeep = 0x1p30;

/// Nine integers: a triangle on the grid.
using Triangle = std::array<glm::ivec3, 3>;
Triangle triangleAt(const double* v) {
  Triangle t;
  for (int k = 0; k < 3; ++k)
    t[k] = {static_cast<int>(v[3 * k]), static_cast<int>(v[3 * k + 1]), static_cast<int>(v[3 * k + 2])};
  return t;
}
std::int64_t doubleAreaOf(const Triangle& t) { return doubleArea(t.data(), 3); }

/// The plane through a triangle with an area: Cramer's rule, as the comment of ScreenPlane defines it.
ScreenPlane planeOf(const Triangle& t) {
  const Int128 x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y, z1 = t[1].z - t[0].z;
  const Int128 x2 = t[2].x - t[0].x, y2 = t[2].y - t[0].y, z2 = t[2].z - t[0].z;
  Int128 A = z1 * y2 - z2 * y1, B = x1 * z2 - x2 * z1, C = x1 * y2 - x2 * y1;
  if (C < 0) A = -A, B = -B, C = -C;
  ScreenPlane plane;
  plane.A = static_cast<std::int64_t>(A), plane.B = static_cast<std::int64_t>(B),
  plane.C = static_cast<std::int64_t>(C);
  plane.D = C * t[0].z - A * t[0].x - B * t[0].y;
  return plane;
}

struct ExactPlane {
  Whole A, B, C, D;
  explicit ExactPlane(const Triangle& t) {
    const ScreenPlane p = planeOf(t);
    A = p.A, B = p.B, C = p.C, D = Whole{boost::multiprecision::cpp_int{p.D}};
  }
  [[nodiscard]] Big at(const Big& x, const Big& y) const {
    return (Big{A} * x + Big{B} * y + Big{D}) / Big{C};
  }
};
/// a x + b y + c is C_P C_Q (z_P - z_Q).
struct ExactLine {
  Whole a, b, c;
};
ExactLine difference(const ExactPlane& P, const ExactPlane& Q) {
  return {P.A * Q.C - Q.A * P.C, P.B * Q.C - Q.B * P.C, P.D * Q.C - Q.D * P.C};
}

std::vector<Coordinate> triangles(int count) {
  std::vector<Coordinate> input;
  for (int k = 0; k < 3 * count; ++k) {
    input.push_back(integers(-kReach, kReach));
    input.push_back(integers(-kReach, kReach));
    input.push_back(integers(0, kDeep));
  }
  return input;
}
/// Turned so that they run counter-clockwise. Without an area there is nothing to judge.
Numbers turned(const Numbers& in, int count) {
  Numbers v = in;
  for (int t = 0; t < count; ++t) {
    const std::int64_t area = doubleAreaOf(triangleAt(&v[9 * t]));
    if (area == 0) return {};
    if (area < 0) std::swap_ranges(&v[9 * t + 3], &v[9 * t + 6], &v[9 * t + 6]);
  }
  return v;
}

double gridNumber(Random& random, double low, double high) {
  switch (random.below(4)) {
    case 0:
      return random.oneIn(2) ? low : high;
    case 1:
      return std::round(std::clamp(random.sign() * random.power(0, 29), low, high));
    case 2:  // the centre of a pixel
      return std::clamp(std::floor(random.uniform(0, 8192)) * 65536 + 32768, low, high);
    default:
      return std::round(random.uniform(low, high));
  }
}
void addTriangle(Numbers& in, Random& random) {
  const bool small = random.oneIn(2);
  const double size = random.power(4, 28);
  double at[3] = {gridNumber(random, -kReach, kReach), gridNumber(random, -kReach, kReach),
                  gridNumber(random, 0, kDeep)};
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const double low = axis == 2 ? 0 : -kReach, high = axis == 2 ? kDeep : kReach;
      in.push_back(small ? std::clamp(std::round(at[axis] + size * random.uniform(-1, 1)), low, high)
                         : gridNumber(random, low, high));
    }
}
/// Nearly in the plane of the triangle at `of`: its corners plus multiples of its edges, rounded, and raised
/// by a few steps.
void addNearlyCoplanar(Numbers& in, std::size_t of, Random& random) {
  const Numbers t(in.begin() + static_cast<std::ptrdiff_t>(of),
                  in.begin() + static_cast<std::ptrdiff_t>(of) + 9);
  const bool same = random.oneIn(3);
  const double raised = random.oneIn(2) ? 0 : random.sign() * std::round(random.power(0, 12));
  for (int k = 0; k < 3; ++k) {
    double p[3];
    const double a = same ? (k == 1) : random.uniform(-1, 1.5), b = same ? (k == 2) : random.uniform(-1, 1.5);
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::round(t[axis] + a * (t[3 + axis] - t[axis]) + b * (t[6 + axis] - t[axis]));
      const double low = axis == 2 ? 0 : -kReach, high = axis == 2 ? kDeep : kReach;
      if (axis == 2) p[axis] += random.oneIn(2) ? raised : static_cast<double>(random.integer(-1, 1));
      in.push_back(std::clamp(p[axis], low, high));
    }
  }
}

/// A triangle of whole multiples of two edges, and another of them: exactly in one plane, if nothing has to
/// be clamped to the grid. Then one corner may be raised by a step.
void addCoplanar(Numbers& in, Random& random) {
  const double size = random.power(1, 26);
  double at[3], edge[2][3];
  for (int axis = 0; axis < 3; ++axis) {
    at[axis] = std::round(axis == 2 ? random.uniform(0, kDeep) : random.uniform(-kReach, kReach));
    for (auto& e : edge) e[axis] = std::round(size * random.uniform(-1, 1));
  }
  for (int corner = 0; corner < 6; ++corner) {
    const double a = static_cast<double>(random.integer(-3, 3)),
                 b = static_cast<double>(random.integer(-3, 3));
    const double raised = corner == 5 && random.oneIn(2) ? random.sign() : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double p = at[axis] + a * edge[0][axis] + b * edge[1][axis] + (axis == 2 ? raised : 0);
      in.push_back(std::clamp(p, axis == 2 ? 0 : -kReach, axis == 2 ? kDeep : kReach));
    }
  }
}

Kernel depthKernel() {
  Kernel kernel{.name = "depth of a plane",
                .claim = "4 2^-53 of it",
                .header = "geometry/view/screen_plane.h",
                .input = triangles(1),
                .prepare = [](const Numbers& in) { return turned(in, 1); },
                .run =
                    [](const Numbers& in) {
                      return Numbers{depthAt(planeOf(triangleAt(in.data())), static_cast<std::int64_t>(in[9]),
                                             static_cast<std::int64_t>(in[10]))};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      const Big exact = ExactPlane{triangleAt(in.data())}.at(big(in[9]), big(in[10]));
                      return shareOf(out[0], exact, 4 * kU * abs(exact));
                    },
                .hard = {[](Random& random) {
                  Numbers in;
                  addTriangle(in, random);
                  for (int k = 0; k < 2; ++k) in.push_back(gridNumber(random, -2 * kReach, 2 * kReach));
                  return in;
                }}};
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  return kernel;
}

/// Where it is right, the share says how much of its filter's tolerance the filter's error takes.
Kernel compareKernel() {
  Kernel kernel{
      .name = "order of two depths",
      .claim = "exact; its filter: 2^-50 (|zP| + |zQ|)",
      .header = "geometry/view/screen_plane.h",
      .input = triangles(2),
      .prepare = [](const Numbers& in) { return turned(in, 2); },
      .run =
          [](const Numbers& in) {
            const ScreenPlane P = planeOf(triangleAt(in.data())), Q = planeOf(triangleAt(&in[9]));
            const auto x = static_cast<std::int64_t>(in[18]), y = static_cast<std::int64_t>(in[19]);
            return Numbers{static_cast<double>(compareDepths(P, Q, x, y)), depthAt(P, x, y),
                           depthAt(Q, x, y)};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const ExactPlane P{triangleAt(in.data())}, Q{triangleAt(&in[9])};
            const Big zP = P.at(big(in[18]), big(in[19])), zQ = Q.at(big(in[18]), big(in[19])),
                      apart = zP - zQ;
            const ExactLine l = difference(P, Q);
            const Whole exact = l.a * Whole{in[18]} + l.b * Whole{in[19]} + l.c;
            if (out[0] != exact.sign()) return kWrong;
            const Big tolerance = 0x1p-50 * (abs(big(out[1])) + abs(big(out[2])));
            if (tolerance == 0) return 0.0;
            return toDouble(abs(big(out[1]) - big(out[2]) - apart) / tolerance);
          },
      .hard = {[](Random& random) {
        Numbers in;
        if (random.oneIn(2)) {
          addCoplanar(in, random);
        } else {
          addTriangle(in, random);
          random.oneIn(3) ? addTriangle(in, random) : addNearlyCoplanar(in, 0, random);
        }
        // At a corner, or anywhere.
        const std::size_t corner = 3 * random.below(6);
        for (std::size_t k = 0; k < 2; ++k)
          in.push_back(random.oneIn(2) ? in[corner + k] : gridNumber(random, -2 * kReach, 2 * kReach));
        return in;
      }}};
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  return kernel;
}

Kernel nearerKernel() {
  Kernel kernel{
      .name = "nearer plane at a sample",
      .claim = "exact",
      .header = "geometry/view/screen_plane.h",
      .input = triangles(2),
      .prepare = [](const Numbers& in) { return turned(in, 2); },
      .run =
          [](const Numbers& in) {
            return Numbers{
                static_cast<double>(nearer(planeOf(triangleAt(in.data())), planeOf(triangleAt(&in[9])),
                                           static_cast<int>(in[18]), static_cast<int>(in[19])))};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const ExactLine l = difference(ExactPlane{triangleAt(in.data())}, ExactPlane{triangleAt(&in[9])});
            const Whole x = Whole{in[18]} * kGrid + kGrid / 2, y = Whole{in[19]} * kGrid + kGrid / 2;
            const Whole value = l.a * x + l.b * y + l.c;
            const Whole& part = value != 0 ? value : l.a != 0 ? l.a : l.b;
            if (out[0] != part.sign()) return kWrong;
            // How small the difference is, as a share of its terms: 0.9 at a tie.
            const Big terms = abs(Big{l.a * x}) + abs(Big{l.b * y}) + abs(Big{l.c});
            return terms == 0 ? 0.0 : 0.9 / (1 + toDouble(abs(Big{value}) / terms) * 0x1p60);
          },
      .hard = {[](Random& random) {
        Numbers in;
        addTriangle(in, random);
        // A corner of both, at the centre of a pixel.
        const double i = static_cast<double>(random.integer(0, 8191)),
                     j = static_cast<double>(random.integer(0, 8191));
        in[0] = i * kGrid + kGrid / 2, in[1] = j * kGrid + kGrid / 2;
        addNearlyCoplanar(in, 0, random);
        if (random.oneIn(2)) std::copy(in.begin(), in.begin() + 3, in.begin() + 9);
        in.push_back(i), in.push_back(j);
        return in;
      }},
      .directed = 1};
  kernel.input.push_back(integers(0, 8191));
  kernel.input.push_back(integers(0, 8191));
  return kernel;
}

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
    scene.planes.push_back(planeOf(t));
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
                const ExactLine l =
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
ExactLine exactly(const Numbers& in, const Line& line) {
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
    std::vector<ExactLine> exact;
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
            const std::vector<ExactLine> lines = sides(in, out);
            const ExactLine third =
                difference(ExactPlane{triangleAt(in.data())}, ExactPlane{triangleAt(&in[27])});
            double worst = 0;
            for (std::size_t k = 0; k < lines.size(); ++k) {
              const ExactLine &l = lines[k], &m = lines[(k + 1) % lines.size()];
              const Whole X = l.b * m.c - m.b * l.c, Y = m.a * l.c - l.a * m.c, W = l.a * m.b - m.a * l.b;
              if (W == 0) return kWrong;
              const Whole value = third.a * X + third.b * Y + third.c * W;
              if (value.sign() * W.sign() != static_cast<int>(out[7 * k + 6])) return kWrong;
              const Big radius = big(out[7 * k + 5]);
              worst = std::max({worst, shareOf(out[7 * k + 3], Big{X} / Big{W}, radius),
                                shareOf(out[7 * k + 4], Big{Y} / Big{W}, radius)});
              // Every corner lies on the inner side of every line.
              for (const ExactLine& other : lines) {
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

ScreenPlane screenPlaneOf(const Numbers& input, std::size_t first) {
  return planeOf(triangleAt(&input[first]));
}

void addPlaneKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(depthKernel());
  kernels.push_back(compareKernel());
  kernels.push_back(nearerKernel());
  kernels.push_back(cutLineKernel());
  kernels.push_back(cutKernel());
}

}  // namespace xnewell
