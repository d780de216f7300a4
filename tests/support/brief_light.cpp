#include "tests/support/brief_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace xnewell {

namespace {

using std::abs, std::sqrt;  // and those of two doubles

constexpr double kInfinity = std::numeric_limits<double>::infinity();

LongVec wide(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// x^n, n a whole number.
Long raised(Long x, int n) {
  Long result = 1;
  for (; n > 0; n /= 2, x *= x)
    if (n % 2 == 1) result *= x;
  return result;
}

/// Twice the vector area.
LongVec areaOf(const std::vector<LongVec>& p) {
  LongVec sum{0};
  for (std::size_t k = 1; k + 1 < p.size(); ++k) sum += cross(p[k] - p[0], p[k + 1] - p[0]);
  return sum;
}

/// A cubic Bernstein polynomial and its derivative.
Long bernstein(int i, Long t) {
  constexpr double kBinomial[]{1, 3, 3, 1};
  return kBinomial[i] * raised(t, i) * raised(1 - t, 3 - i);
}
Long slope(int i, Long t) {
  const auto quadratic = [&](int k) {
    constexpr double kBinomial[]{1, 2, 1};
    return k < 0 || k > 2 ? Long{0} : kBinomial[k] * raised(t, k) * raised(1 - t, 2 - k);
  };
  return 3 * (quadratic(i - 1) - quadratic(i));
}

/// f of BRIEF.md: what the distance leaves, `d` in scene units.
Long left(const Light& light, Long d, Long unit) {
  switch (light.attenuation) {
    case Attenuation::None:
      return 1;
    case Attenuation::Inverse:
      return d <= unit ? 1 : unit / d;
    case Attenuation::InverseSquare:
      return d <= unit ? 1 : (unit / d) * (unit / d);
    case Attenuation::Linear:
      return std::max<Long>(0, 1 - d / light.range);
    case Attenuation::Textbook:
      return std::min<Long>(1, 1 / (light.c.x + light.c.y * d + light.c.z * d * d));
  }
  return 0;
}

/// s of BRIEF.md: the share that a spot sends along the unit vector `out`.
Long spot(const Light& light, const LongVec& out) {
  if (light.kind != LightKind::Spot) return 1;
  const Long a = dot(normalize(wide(light.direction)), out);
  const Long inner = std::cos(radians(light.inner)), outer = std::cos(radians(light.outer));
  if (a >= inner) return 1;
  return a <= outer ? 0 : raised((a - outer) / (inner - outer), light.falloff);
}

}  // namespace

BriefLight::BriefLight(const Scene& scene, const Camera& camera, const Illumination& user, int width,
                       int height)
    : scene_{scene}, camera_{camera}, user_{user}, width_{width}, height_{height} {
  n_ = normalize(wide(camera.view.vpn));
  u_ = normalize(cross(normalize(wide(camera.view.vup)), n_));
  v_ = cross(n_, u_);
  for (int k = 0; k < scene.parts.count(); ++k) {
    Part part;
    for (int c = scene.parts.firstCorner[k]; c < scene.parts.firstCorner[k + 1]; ++c)
      part.corners.push_back(corner(scene.parts.from[c]));
    part.N = areaOf(part.corners);
    parts_.push_back(std::move(part));
  }
}

LongVec BriefLight::corner(int meshCorner) const {
  return wide(scene_.mesh.points[scene_.mesh.corners[meshCorner]]) - wide(camera_.view.vrp);
}

BriefLight::Ray BriefLight::ray(Long x, Long y) const {
  const ViewSpec& view = camera_.view;
  const auto world = [&](Long u, Long v, Long n) { return u * u_ + v * v_ + n * n_; };
  const Long wu = view.windowMin.x + (Long{view.windowMax.x} - view.windowMin.x) * x / width_;
  const Long wv = view.windowMax.y - (Long{view.windowMax.y} - view.windowMin.y) * y / height_;
  const LongVec prp = world(view.prp.x, view.prp.y, view.prp.z);
  if (view.projection == Projection::Perspective) return {prp, world(wu, wv, 0) - prp};
  const LongVec centre = world((Long{view.windowMin.x} + view.windowMax.x) / 2,
                               (Long{view.windowMin.y} + view.windowMax.y) / 2, 0);
  return {world(wu, wv, 0), centre - prp};
}

BriefLight::Seen BriefLight::seen(Long x, Long y) const {
  const Ray r = ray(x, y);
  const ViewSpec& view = camera_.view;
  Seen seen;
  Long nearest = kInfinity, next = nearest;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const auto& [corners, N] = parts_[k];
    const Long slant = dot(N, r.along);
    if (slant == 0) continue;
    const Long t = dot(N, corners[0] - r.from) / slant;
    const LongVec at = r.from + t * r.along;
    const Long depth = dot(n_, at);
    if (depth > view.front || depth < view.back) continue;
    bool inside = true;
    for (std::size_t c = 0; c < corners.size() && inside; ++c)
      inside = dot(N, cross(corners[(c + 1) % corners.size()] - corners[c], at - corners[c])) >= 0;
    if (!inside) continue;
    if (t < nearest)
      next = nearest, nearest = t, seen.part = static_cast<int>(k);
    else
      next = std::min(next, t);
  }
  if (seen.part >= 0) seen.gap = (next - nearest) * length(r.along) / (view.windowMax.y - view.windowMin.y);
  return seen;
}

BriefLight::Place BriefLight::place(int part, const Ray& r) const {
  const int first = scene_.parts.firstCorner[part], count = scene_.parts.firstCorner[part + 1] - first;
  Place best{};
  Long largestLeast = -kInfinity;
  for (int k = 1; k + 1 < count; ++k) {
    const int from[3]{scene_.parts.from[first], scene_.parts.from[first + k],
                      scene_.parts.from[first + k + 1]};
    const LongVec a = corner(from[0]), b = corner(from[1]), c = corner(from[2]);
    const LongVec N = cross(b - a, c - a);
    const Long slant = dot(N, r.along);
    if (slant == 0) continue;
    const LongVec at = r.from + dot(N, a - r.from) / slant * r.along;
    const Long square = dot(N, N);
    const Long share[3]{dot(N, cross(c - b, at - b)) / square, dot(N, cross(a - c, at - c)) / square,
                        dot(N, cross(b - a, at - a)) / square};
    const Long least = std::min({share[0], share[1], share[2]});
    if (least <= largestLeast) continue;
    largestLeast = least;
    Long sum = 0;
    for (int i = 0; i < 3; ++i) sum += std::max<Long>(0, share[i]);
    for (int i = 0; i < 3; ++i) best.corner[i] = from[i], best.share[i] = std::max<Long>(0, share[i]) / sum;
  }
  for (int i = 0; i < 3; ++i) best.at += best.share[i] * corner(best.corner[i]);
  return best;
}

LongVec BriefLight::newell(int face) const {
  std::vector<LongVec> p;
  for (int c = scene_.mesh.firstCorner[face]; c < scene_.mesh.firstCorner[face + 1]; ++c)
    p.push_back(corner(c));
  return normalize(areaOf(p));
}

LongVec BriefLight::normal(const Place& place, int face, bool& sure) const {
  const Mesh& mesh = scene_.mesh;
  const Long toFile = std::ldexp(1.0, scene_.exponent);
  for (const RoundRun& run : scene_.rounds) {
    if (face < run.firstFace || face >= run.firstFace + run.faces) continue;
    // The solid is f = 0 in its own coordinates; the gradient in the world is the transposed inverse's.
    const glm::mat<3, 3, Long> axes{wide(run.axes[0]), wide(run.axes[1]), wide(run.axes[2])};
    const LongVec from = wide(camera_.view.vrp) * toFile - wide(run.centre);
    const LongVec own = inverse(axes) * (place.at * toFile + from);
    LongVec gradient = own;
    if (run.solid == RoundSolid::Torus)
      gradient -= LongVec{own.x, own.y, 0} / sqrt(own.x * own.x + own.y * own.y);
    return normalize(transpose(inverse(axes)) * gradient);
  }
  for (const PatchRun& run : scene_.patches) {
    const int n = run.divisions, cells = n * n;
    int firstFace = 0;
    while (mesh.firstCorner[firstFace] != run.firstCorner) ++firstFace;
    const int cell = face - firstFace;
    if (cell < 0 || cell >= static_cast<int>(run.patches.size()) * cells) continue;
    const std::array<glm::dvec3, 16>& p = run.patches[cell / cells].p;
    // The corners of the cell in its order: parameters in cells, and which of the face's corners lies there.
    const int row = cell % cells / n, column = cell % n;
    const int rows[4]{row, row + 1, row + 1, row}, columns[4]{column, column, column + 1, column + 1};
    const int faceFirst = mesh.firstCorner[face];
    const bool pole = mesh.firstCorner[face + 1] - faceFirst == 3;
    // A pole: the corner of the cell that is missing in the face coincides with the next one. The cell's
    // place at shares (pole, next, last) is on the line from the pole through ((next, last), divided as they
    // are).
    Long u = 0, v = 0;
    if (!pole) {
      for (int i = 0; i < 3; ++i) {
        const int c = place.corner[i] - faceFirst;
        u += place.share[i] * rows[c] / n, v += place.share[i] * columns[c] / n;
      }
    } else {
      int missing = 0;  // the parameters of the listed corners tell which
      for (int c = 0; c < 4; ++c) {
        bool listed = false;
        for (int k = 0; k < 3; ++k) {
          const glm::dvec2 uv = mesh.uv[mesh.uvOfCorner[faceFirst + k]];
          listed |= std::lround(uv.x * n) == rows[c] && std::lround(uv.y * n) == columns[c];
        }
        if (!listed) missing = c;
      }
      Long share[4]{};  // of the cell's corners
      for (int i = 0; i < 3; ++i) {
        int c = place.corner[i] - faceFirst;
        if (c >= missing) ++c;
        share[c] = place.share[i];
      }
      const int next = (missing + 1) % 4, second = (missing + 2) % 4, last = (missing + 3) % 4;
      const Long atPole = share[next], rest = share[second] + share[last];
      sure &= rest > 1e-4;
      share[next] = atPole * share[second] / rest;
      share[missing] = atPole * share[last] / rest;
      for (int c = 0; c < 4; ++c) u += share[c] * rows[c] / n, v += share[c] * columns[c] / n;
    }
    LongVec du{0}, dv{0};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const LongVec control = wide(p[4 * i + j]) - wide(p[0]);
        du += slope(i, u) * bernstein(j, v) * control;
        dv += bernstein(i, u) * slope(j, v) * control;
      }
    const LongVec N = cross(du, dv);
    Long size = 0;  // of the patch
    for (const glm::dvec3& q : p) size = std::max(size, length(wide(q) - wide(p[0])));
    sure &= length(N) > 1e-3 * size * size;
    return normalize(N);
  }
  return newell(face);
}

LongVec BriefLight::texel(const Place& place, int face, bool& sure) const {
  const Mesh& mesh = scene_.mesh;
  const int material = mesh.material[face];
  if (material < 0 || mesh.materials[material].texture < 0) return LongVec{1};
  const Texture& texture = scene_.textures[mesh.materials[material].texture];
  Long u = 0, v = 0;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec2 uv = mesh.uv[mesh.uvOfCorner[place.corner[i]]];
    u += place.share[i] * uv.x, v += place.share[i] * uv.y;
  }
  const auto along = [&](Long t, int size) {
    const Long texels = (t - std::floor(static_cast<double>(t))) * size,
               border = texels - std::round(static_cast<double>(texels));
    sure &= abs(border) > 1e-6;
    return static_cast<int>(static_cast<double>(texels));
  };
  const int column = along(u, texture.width), row = texture.height - 1 - along(v, texture.height);
  LongVec result;
  for (int c = 0; c < 3; ++c) result[c] = texture.channel[c][row * texture.width + column] / Long{255};
  return result;
}

BriefLight::Lit BriefLight::light(int part, int i, int j) const {
  Lit lit;
  const Ray r = ray(i + Long{0.5}, j + Long{0.5});
  const Place at = place(part, r);
  const int face = scene_.parts.face[part];
  LongVec N = normal(at, face, lit.sure);
  const LongVec area = areaOf(parts_[part].corners);
  const Long facing = dot(area, r.along) / length(area) / length(r.along);
  lit.sure &= abs(facing) > 1e-3;  // not edge-on
  if (facing > 0 && user_.twoSided) N = -N;
  const LongVec P = at.at + wide(camera_.view.vrp);
  const LongVec V = normalize(wide(camera_.eye) - P);
  const MeshMaterial material =
      scene_.mesh.material[face] < 0 ? MeshMaterial{} : scene_.mesh.materials[scene_.mesh.material[face]];
  const LongVec Od = wide(material.diffuse) * texel(at, face, lit.sure), Os = wide(material.specular);

  lit.I = wide(scene_.light.Ia.value_or(glm::dvec3{user_.Ia})) * wide(material.diffuse) *
          Long{material.ka.value_or(user_.ka)};
  std::vector<Light> lights = scene_.light.lights;
  if (lights.empty()) {
    Light light;
    light.Ip = glm::dvec3{user_.Ip};
    light.direction = user_.light;
    if (user_.lightPosition) {
      light.kind = LightKind::Point;
      light.position = *user_.lightPosition * std::ldexp(1.0, -scene_.exponent);
    }
    lights.push_back(light);
  }
  if (user_.attenuation) {
    glm::dvec3 low{INFINITY}, high{-INFINITY};
    for (const glm::dvec3& p : scene_.mesh.points) low = min(low, p), high = max(high, p);
    for (Light& light : lights) {
      if (light.kind == LightKind::Directional) continue;
      light.attenuation = *user_.attenuation;
      // The defaults of the options --range and --coefficients, by the distance to the scene's centre.
      const double d = glm::length(light.position - (low + high) / 2.0);
      // The user's lengths are in the file's units.
      const double file = std::ldexp(1.0, scene_.exponent);
      light.range = user_.range ? *user_.range / file : 2 * d;
      light.c = user_.c ? *user_.c * glm::dvec3{1, file, file * file} : glm::dvec3{1, 0, 1 / (d * d)};
    }
  }
  for (const Light& light : lights) {
    const bool far = light.kind == LightKind::Directional;
    const LongVec to = far ? wide(light.direction) : wide(light.position) - P;
    const LongVec L = normalize(to);
    const Long NL = dot(N, L);
    if (NL <= 0) continue;
    const Long arrives = (far ? 1 : left(light, length(to), scene_.light.unit)) * spot(light, -L);
    const LongVec R = Long{2} * N * NL - L;
    const Long cosine = user_.form == Form::Textbook     ? dot(R, V)
                        : user_.form == Form::HalfVector ? dot(N, normalize(L + V))
                                                         : NL;
    const Long highlight = raised(std::max<Long>(0, cosine), material.n.value_or(user_.n));
    lit.I += arrives * wide(light.Ip) *
             (Long{material.kd.value_or(user_.kd)} * Od * NL +
              Long{material.ks.value_or(user_.ks)} * Os * highlight);
  }
  lit.I = clamp(lit.I, LongVec{0}, LongVec{1});
  return lit;
}

}  // namespace xnewell
