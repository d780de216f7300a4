#include "geometry/model/bezier.h"
#include "geometry/model/vertex_normals.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

/// The cubic Bernstein polynomials, or those of degree 2, at t.
std::array<Big, 4> bernstein(int degree, const Big& t) {
  const Big s = 1 - t;
  if (degree == 2) return {s * s, 2 * s * t, t * t, Big{0}};
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// One coordinate of a surface point. In an input: 16 coordinates, u, v.
Kernel bezierPointKernel() {
  Kernel kernel{.name = "Bezier point",
                .claim = "2^-49 of the largest coordinate, and 2^-1070",
                .header = "geometry/model/bezier.h",
                .input = std::vector<Coordinate>(16, doubles(-0x1p1000, 0x1p1000)),
                .run =
                    [](const Numbers& in) {
                      BezierPatch patch;
                      for (int k = 0; k < 16; ++k) patch.p[k] = {in[k], 0, 0};
                      return Numbers{point(patch, in[16], in[17]).x};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      const auto u = bernstein(3, big(in[16])), v = bernstein(3, big(in[17]));
                      Big sum = 0;
                      double most = 0;
                      for (int k = 0; k < 16; ++k) {
                        sum += u[k / 4] * v[k % 4] * big(in[k]);
                        most = std::max(most, std::abs(in[k]));
                      }
                      return shareOf(out[0], sum, big(most) * 0x1p-49 + 0x1p-1070);
                    },
                .hard = {[](Random& random) {  // all as large as the largest
                           Numbers in;
                           const double size = random.power(-1060, 999);
                           const bool level = random.oneIn(2);
                           for (int k = 0; k < 16; ++k)
                             in.push_back(size * (level ? 1 : random.sign()) * (1 - random.power(-53, -1)));
                           for (int k = 0; k < 2; ++k) in.push_back(random.uniform(0, 1));
                           return in;
                         },
                         [](Random& random) {
                           Numbers in;
                           for (int k = 0; k < 16; ++k) in.push_back(random.uniform(-4, 4));
                           for (int k = 0; k < 2; ++k)
                             in.push_back(random.oneIn(2) ? random.power(-60, 0) : 1 - random.power(-53, -1));
                           return in;
                         }}};
  kernel.input.push_back(doubles(0, 1));
  kernel.input.push_back(doubles(0, 1));
  return kernel;
}

/// The normal, where du x dv is no rounding. In an input: 48 coordinates, u, v.
Kernel bezierNormalKernel() {
  struct Derivatives {
    BigVec product{0, 0, 0};
    Big longest;  ///< of the edges along u times that along v
  };
  const auto derivatives = [](const Numbers& in) {
    const auto at = [&](int i, int j) { return bigVec(&in[3 * (4 * i + j)]); };
    const auto u2 = bernstein(2, big(in[48])), u3 = bernstein(3, big(in[48]));
    const auto v2 = bernstein(2, big(in[49])), v3 = bernstein(3, big(in[49]));
    BigVec du{0, 0, 0}, dv{0, 0, 0};
    Big longestU = 0, longestV = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) {
        const BigVec alongU = at(i + 1, j) - at(i, j), alongV = at(j, i + 1) - at(j, i);
        du = du + alongU * (u2[i] * v3[j]);
        dv = dv + alongV * (v2[i] * u3[j]);
        longestU = largerOf(longestU, dot(alongU, alongU));
        longestV = largerOf(longestV, dot(alongV, alongV));
      }
    return Derivatives{cross(du, dv), sqrt(longestU) * sqrt(longestV)};
  };
  Kernel kernel{
      .name = "Bezier normal",
      .claim = "2^-47 E / |du x dv / 9|, E the product of the longest edges",
      .header = "geometry/model/bezier.h",
      .input = std::vector<Coordinate>(48, doubles(-0x1p500, 0x1p500)),
      .run =
          [](const Numbers& in) {
            BezierPatch patch;
            for (int k = 0; k < 16; ++k) patch.p[k] = {in[3 * k], in[3 * k + 1], in[3 * k + 2]};
            const glm::dvec3 N = normal(patch, in[48], in[49]);
            return Numbers{N.x, N.y, N.z};
          },
      .judge =
          [derivatives](const Numbers& in, const Numbers& out) {
            const Derivatives d = derivatives(in);
            const Big length = lengthOf(d.product);
            if (length <= 0x1p-39 * d.longest) return 0.0;  // it may vanish, and a limit take its place
            return toDouble(lengthOf(bigVec(out.data()) - d.product * (1 / length)) * length /
                            (0x1p-47 * d.longest));
          },
      .hard = {[](Random& random) {
                 Numbers in;
                 const double size = random.power(-400, 400);
                 for (int k = 0; k < 48; ++k) in.push_back(size * random.uniform(-1, 1));
                 for (int k = 0; k < 2; ++k) in.push_back(random.uniform(0, 1));
                 return in;
               },
               [](Random& random) {  // rows nearly at one place, or rows and columns nearly parallel
                 Numbers in;
                 const double off = random.power(-40, 0), bend = random.power(-40, 0);
                 const bool pole = random.oneIn(2);
                 for (int i = 0; i < 4; ++i)
                   for (int j = 0; j < 4; ++j) {
                     const double wide = pole && i == 0 ? off : 1;
                     in.push_back(wide * (j + 0.3 * random.uniform(-1, 1)) + (pole ? 0 : i * 1.0));
                     in.push_back(pole ? i + 0.3 * random.uniform(-1, 1) : off * random.uniform(-1, 1));
                     in.push_back(bend * random.uniform(-1, 1));
                   }
                 in.push_back(pole ? random.power(-40, 0) : random.uniform(0, 1));
                 in.push_back(random.uniform(0, 1));
                 return in;
               }},
      .effort = 0.5};
  kernel.input.push_back(doubles(0, 1));
  kernel.input.push_back(doubles(0, 1));
  return kernel;
}

/// The normal at the apex of a fan of three triangles. In an input: the rule, then apex and four corners.
Kernel vertexNormalKernel() {
  static constexpr std::array kRules{NormalRule::Sum, NormalRule::Area, NormalRule::Angle};
  Kernel kernel{.name = "vertex normal of a fan",
                .claim = "2^-47 (W + sum of w e) / |sum of w N|",
                .header = "geometry/model/vertex_normals.h",
                .input = std::vector<Coordinate>(16, doubles(-0x1p100, 0x1p100)),
                .run =
                    [](const Numbers& in) {
                      Mesh mesh;
                      for (int k = 0; k < 5; ++k)
                        mesh.points.emplace_back(in[3 * k + 1], in[3 * k + 2], in[3 * k + 3]);
                      for (int k = 1; k < 4; ++k) mesh.addFace(std::array{0, k, k + 1}, 0);
                      const Vertices vertices = smoothVertices(mesh, kRules[static_cast<std::size_t>(in[0])]);
                      const glm::dvec3 N = vertices.vertices[vertices.ofCorner[0]].N;
                      return Numbers{N.x, N.y, N.z};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      const NormalRule rule = kRules[static_cast<std::size_t>(in[0])];
                      BigVec sum{0, 0, 0};
                      Big total = 0, doubt = 0;
                      for (int k = 1; k < 4; ++k) {
                        const BigVec apex = bigVec(&in[1]);
                        const BigVec a = bigVec(&in[1 + 3 * k]) - apex, b = bigVec(&in[4 + 3 * k]) - apex;
                        const BigVec v = cross(a, b);
                        const Big area = lengthOf(v), longest = largerOf(dot(a, a), dot(b, b));
                        // Nothing is claimed for faces that are nearly lines, or so small that their area is
                        // no number.
                        if (area < longest * 0x1p-30 || longest < 0x1p-900) return 0.0;
                        const Big weight = rule == NormalRule::Sum    ? Big{1}
                                           : rule == NormalRule::Area ? area
                                                                      : Big{atan2(area, dot(a, b))};
                        sum = sum + v * Big{weight / area};
                        total += weight;
                        doubt += weight * longest / area;
                      }
                      const Big length = lengthOf(sum);
                      if (length <= 0x1p-30 * total) return 0.0;
                      const Big bound = 0x1p-47 * (total + doubt) / length;
                      return toDouble(lengthOf(bigVec(out.data()) - sum * (1 / length)) / bound);
                    },
                .hard = {[](Random& random) {
                  Numbers in{static_cast<double>(random.below(3))};
                  const double far = random.oneIn(2) ? random.power(-10, 10) : 0, thin = random.power(-20, 0);
                  for (int k = 0; k < 5; ++k)
                    for (int axis = 0; axis < 3; ++axis) {
                      const double part = (axis == 0 && random.oneIn(2) ? thin : 1) * random.uniform(-1, 1);
                      in.push_back(k == 0 ? far * random.uniform(-1, 1)
                                          : in[static_cast<std::size_t>(1 + axis)] + part);
                    }
                  return in;
                }},
                .effort = 0.5};
  kernel.input[0] = integers(0, 2);
  return kernel;
}

}  // namespace

void addModelKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(bezierPointKernel());
  kernels.push_back(bezierNormalKernel());
  kernels.push_back(vertexNormalKernel());
}

}  // namespace xnewell
