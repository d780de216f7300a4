#include "x11/pixel/pixel_drawings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "x11/pixel/pixel_page.h"

namespace xnewell {

namespace {

Ramp rampOf(const PixelStory& story, const Explanation& e) {
  const Picture& picture = story.picture;
  return picture.colors().ramps()[picture.scene().mesh.material[picture.snapped().faces[e.face].number] + 1];
}

/// The intensity of a place with this normal, in the light that falls on the pixel.
double intensityOf(const ExplainedEquation& at, int channel, const Illumination& user, const glm::dvec3& N,
                   const glm::dvec3& V, const std::vector<glm::dvec3>& L) {
  double I = at.ambient[channel];
  for (std::size_t k = 0; k < at.lights.size(); ++k) {
    const ExplainedLight& light = at.lights[k];
    const LightTerms terms = lightTerms(user.mistake, light.fatt * light.spot, light.Ip[channel],
                                        at.surface[channel], {N, L[k], V}, user.form);
    I += terms.diffuse + terms.specular;
  }
  return std::clamp(I, 0.0, 1.0);
}

/// The vector before a mistake changed its sign, so that a mistake is not made twice.
glm::dvec3 rightOne(Mistake mistake, const glm::dvec3& v, glm::dvec3 EquationVectors::*which) {
  return taken(rowOf(mistake), {v, v, v}).*which;  // each changes a sign, or nothing
}

/// A vector: its end stands at `from` + (x, -y), and it is dashed where it points away.
void drawArrow(Painter& paint, const Rect& area, glm::ivec2 from, const glm::dvec3& v, std::string_view name,
               std::uint8_t cell, std::optional<std::uint8_t> rim = {}) {
  const auto onPaper = [](double along, int start) { return start + static_cast<int>(std::lround(along)); };
  const int x = onPaper(v.x, from.x), y = onPaper(-v.y, from.y), thick = name == "N" ? 2 : 1;
  if (rim) paint.line(from.x, from.y, x, y, *rim, {.thickness = thick + 2}), paint.disc(x, y, 3, *rim);
  paint.line(from.x, from.y, x, y, cell,
             {.thickness = thick, .on = v.z < 0.0 ? 3 : 1, .off = v.z < 0.0 ? 3 : 0});
  paint.disc(x, y, 2, cell);
  const double along = std::max(1e-9, std::hypot(v.x, v.y));
  const int left = std::clamp(onPaper(9 * v.x / along, x) - 3, area.x + 2, area.x + area.width - 9),
            baseline = std::clamp(onPaper(-9 * v.y / along, y) + 4, area.y + 11, area.y + area.height - 3);
  if (rim)
    paint.haloed(left, baseline, name, cell, *rim);
  else
    paint.text(left, baseline, name, cell, Voice::Bold);
}

}  // namespace

void drawVectors(Pen& pen, const Rect& area, glm::ivec2 place, const PixelStory& story,
                 const ExplainedEquation& at) {
  if (at.lights.empty()) return;
  Painter paint = pen.paint.within(area);
  const glm::dmat3 seen = vrcRotation(story.picture.camera().view);
  const auto arrow = [&](const glm::dvec3& world, std::string_view name) {
    drawArrow(paint, area, place, seen * unit(world) * (area.height / 5.0), name, pen(Cell::White),
              pen(Cell::Black));
  };
  const ExplainedLight& light = at.lights.front();
  const Form form = story.picture.settings().light.form;
  if (form != Form::Tutorial && light.R != glm::dvec3{0.0})
    arrow(light.R, form == Form::Textbook ? "R" : "H");
  arrow(light.L, "L");
  arrow(at.N, "N");
}

void drawNeighbourhood(Pen& pen, const Rect& area, const PixelStory& story, int face) {
  Painter& paint = pen.paint;
  const int side = area.width / (2 * kAround + 1);
  pen.caps(area.x, area.y - 8, "neighbourhood");
  const IndexImage& image = story.picture.image();
  for (int dj = -kAround; dj <= kAround; ++dj)
    for (int di = -kAround; di <= kAround; ++di) {
      const int i = story.i + di, j = story.j + dj;
      const bool inside = i >= 0 && j >= 0 && i < image.width && j < image.height;
      paint.fillRect({area.x + (di + kAround) * side, area.y + (dj + kAround) * side, side, side},
                     inside ? image.row(j)[i] : pen(Cell::Panel));
    }
  if (face >= 0) {
    const SnappedScene& scene = story.picture.snapped();
    const SnappedFace& shown = scene.faces[face];
    Painter inside = paint.within({area.x, area.y, side * (2 * kAround + 1), side * (2 * kAround + 1)});
    const auto place = [&](int k) {
      const glm::ivec3& v = scene.vertices[shown.first + k % shown.count];
      const auto along = [&](int coordinate, int pixel, int from) {
        const double pixels = coordinate / 65536.0 - (pixel - kAround);
        return from + static_cast<int>(std::clamp(std::floor(pixels * side), -1e5, 1e5));
      };
      return std::pair{along(v.x, story.i, area.x), along(v.y, story.j, area.y)};
    };
    for (const auto& [cell, thick] : {std::pair{Cell::Black, 3}, {Cell::White, 1}})
      for (int k = 0; k < shown.count; ++k) {
        const auto [x0, y0] = place(k);
        const auto [x1, y1] = place(k + 1);
        inside.line(x0, y0, x1, y1, pen(cell), {.thickness = thick});
      }
  }
  const Rect middle{area.x + kAround * side, area.y + kAround * side, side, side};
  paint.frame({middle.x - 1, middle.y - 1, side + 2, side + 2}, pen(Cell::Black));
  paint.frame(middle, pen(Cell::White));
  paint.fillRect({middle.x + side / 2 - 1, middle.y + side / 2 - 1, 2, 2}, pen(Cell::White));
}

glm::dmat3 ballFromWorld(const ExplainedEquation& at, const BallTurn& turn) {
  const glm::dvec3 N = unit(at.N), L = at.lights.empty() ? at.V : at.lights.front().L;
  // Towards the viewer: across N and L, and on the side of V.
  glm::dvec3 towards = unit(glm::cross(N, L));
  if (glm::length(towards) < 0.5) towards = unit(glm::cross(N, glm::dvec3{N.z, N.x, N.y} + at.V));
  if (glm::dot(towards, at.V) < 0.0) towards = -towards;
  const glm::dvec3 right = glm::cross(N, towards);
  const SinCos a = sinCosDegrees(turn.around), d = sinCosDegrees(turn.down);
  const glm::dvec3 x = a.cos * right - a.sin * towards, z = a.sin * right + a.cos * towards;
  return glm::transpose(glm::dmat3{x, d.cos * N - d.sin * z, d.sin * N + d.cos * z});
}

void drawBall(Pen& pen, const Rect& area, const PixelStory& story, const Explanation& e,
              const ExplainedEquation& at, int channel, const BallTurn& turn) {
  pen.paint.fillRect(area, pen(Cell::Well));
  Painter paint = pen.paint.within(area);
  const Illumination& user = story.picture.settings().light;
  const int radius = std::min(area.width, area.height) * 2 / 5;
  const int cx = area.x + area.width / 2, cy = area.y + area.height - radius / 3;
  const glm::dmat3 turned = ballFromWorld(at, turn);
  std::vector<glm::dvec3> L;
  for (const ExplainedLight& light : at.lights)
    L.push_back(turned * rightOne(user.mistake, light.L, &EquationVectors::L));
  const glm::dvec3 V = turned * rightOne(user.mistake, at.V, &EquationVectors::V);
  const double length = glm::length(at.N);  // where a mistake leaves N as long as it is
  const Ramp ramp = rampOf(story, e);
  for (int y = -radius; y <= radius && !story.inColors(); ++y)
    for (int x = -radius; x <= radius; ++x) {
      const double rest = static_cast<double>(radius) * radius - x * x - y * y;
      if (rest < 0) continue;
      const glm::dvec3 N = glm::dvec3{x, -y, std::sqrt(rest)} * (length / radius);
      paint.point(cx + x, cy + y, ramp.cell(intensityOf(at, channel, user, N, V, L)));
    }
  paint.ring(cx, cy, radius + 1, pen(Cell::WellLine));
  // The place with the pixel's N, and the arrows from there.
  const glm::dvec3 up = turned * unit(rightOne(user.mistake, at.N, &EquationVectors::N));
  const auto onPaper = [](double v, int from) { return from + static_cast<int>(std::lround(v)); };
  const int px = onPaper(radius * up.x, cx), py = onPaper(-radius * up.y, cy);
  const int reach = py - area.y - 14;
  const auto arrow = [&](const glm::dvec3& world, std::string_view name, Cell cell) {
    drawArrow(paint, area, {px, py}, turned * unit(world) * double(reach), name, pen(cell));
  };
  arrow(at.V, "V", Cell::WellText);
  if (!at.lights.empty()) {
    const ExplainedLight& light = at.lights.front();
    if (user.form != Form::Tutorial && light.R != glm::dvec3{0.0})
      arrow(light.R, user.form == Form::Textbook ? "R" : "H", Cell::WellText);
    arrow(light.L, "L", Cell::WellText);
  }
  arrow(at.N, "N", Cell::White);
  paint.disc(px, py, 2, pen(Cell::White));
}

void drawTerms(Pen& pen, const Rect& area, const std::array<double, 3>& terms) {
  const Rect whole{area.x, area.y, area.width - 24, area.height};
  Painter& paint = pen.paint;
  paint.fillRect(whole, pen(Cell::Panel));
  double from = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const auto place = [&](double I) {
      return whole.x + static_cast<int>(std::lround(std::min(1.0, I) * whole.width));
    };
    const Rect part{place(from), whole.y, place(from + terms[k]) - place(from), whole.height};
    from += terms[k];
    if (part.width <= 0) continue;
    paint.fillRect(part, pen(std::array{Cell::Soft, Cell::Rule, Cell::White}[k]));
    if (k > 0) paint.stipple(part, k == 1 ? Stipple::Quarter : Stipple::Diagonals, pen(Cell::Ink));
  }
  paint.frame(whole, pen(Cell::Faint));
  if (from > 1.0)
    paint.fillRect({whole.x + whole.width, whole.y,
                    std::min(24, static_cast<int>((from - 1.0) * whole.width) + 1), whole.height},
                   pen(Cell::Alarm));
}

void drawMap(Pen& pen, const Rect& area, const PixelStory& story, const Explanation& e, int channel) {
  Painter& paint = pen.paint;
  const Surfaces s = story.picture.surfaces();
  const Environment& map =
      s.shading.environments(channel)[s.mesh.material[s.snapped.faces[e.face].number] + 1];
  const Ramp ramp = rampOf(story, e);
  const bool away = e.place && e.place->away;
  const int side = std::min(area.width, area.height);
  const auto cellAt = [&](int x, int y) {
    const auto place = [&](int v) { return static_cast<std::size_t>((2 * v + 1) * 128 / side); };
    return ramp.cell((away ? map.away : map.front)[256 * place(y) + place(x)]);
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (!story.inColors()) paint.point(area.x + x, area.y + y, cellAt(x, y));
  paint.frame({area.x, area.y, side, side}, pen(Cell::Faint));
  if (!e.place) return;
  Painter inside = paint.within({area.x, area.y, side, side});
  const int x = area.x + e.place->column * side / 256, y = area.y + e.place->row * side / 256;
  inside.ring(x, y, 6, pen(Cell::Black));
  inside.ring(x, y, 5, pen(Cell::White));
  inside.fillRect({x, y, 1, 1}, pen(Cell::White));
}

}  // namespace xnewell
