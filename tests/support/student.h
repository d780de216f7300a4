#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace student {

/// A second program for the assignment, as a student might write it: it has its own vectors, projection,
/// polygon filler, shading and table, and shares no code with xnewell. It rounds the corners of polygons to
/// whole pixels, and its edges are inclusive, so its outlines are not xnewell's. `mistake` plants one of the
/// mistakes that shading/diagnose knows, by its key; `variant` does something that the course allows.

using Triple = std::array<double, 3>;

struct Surface {
  double ka = 0.9, kd = 0.9, ks = 0.4;
  int n = 20;
};

struct World {
  std::vector<Triple> points;
  std::vector<std::vector<int>> faces;
  std::vector<Surface> surfaces;  ///< of each face
  Triple eye{}, at{}, up{0, 0, 1};
  double fov = 30;  ///< degrees, of the height
  /// For Program::byMatrices: the window's centre, in half heights of it; the planes, as distances.
  std::array<double, 2> shift{};
  double front = 0.1, back = 100;
  Triple light{};     ///< a place, or a direction to the light
  bool lamp = false;  ///< a place; its light fades by min(1, 1/d^2)
  double Ia = 0.2, Ip = 0.7;
};

struct Program {
  char method = 'f';  ///< f: flat, g: Gouraud, p: Phong
  char table = 'l';   ///< b: brief, l: linear, c: corrected
  std::string mistake = {}, variant = {};
  std::string second = {};  ///< another mistake, or another variant
  /// What the program computes once it uses twice: N.L with its mistake also in R and to ask for a highlight,
  /// V also to turn N, r also to find a cell.
  bool flows = false;
  double I0 = 0.02;         ///< of the corrected table
  bool byMatrices = false;  ///< student_view.h; flat, with exact edges
  bool half = false;        ///< corners half a pixel off
  bool zbuffer = false;     ///< else sorted by far z, or by mean z with the variant "zmean"
  int width = 640, height = 480;
};

/// Each pixel's cell (0 where nothing shows), and what it shows as red, 0 to 255.
struct Result {
  int width = 0, height = 0;
  std::vector<int> cell;
  std::vector<std::uint8_t> red;
  std::array<std::uint8_t, 256> held{};  ///< of the table
};

[[nodiscard]] Result draw(const World& world, const Program& program);

}  // namespace student
