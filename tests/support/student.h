#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace student {

/// A second program for the assignment, as a student might write it: it has its own vectors, projection,
/// polygon filler, shading and table, and shares no code with xnewell. It rounds the corners of polygons to
/// whole pixels, and its edges are inclusive, so its outlines are not xnewell's. `mistake` plants one of the
/// mistakes that shading/diagnose knows, by its key; `variant` does something that the course allows.

using Triple = std::array<double, 3>;

inline double dotOf(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Triple crossOf(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

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
  bool byMatrices = false;  ///< drawByMatrices(); flat, with exact edges
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

/// What the equation has at a place, for one light.
struct Place {
  Triple N, L, V, P;
  double NL, NV, RV, d, f, Ip, Ia, ka, kd, ks;
  int n;
};

/// Mistakes of the equation that no list of shading/diagnose has. Their keys begin with "off-".
[[nodiscard]] const std::vector<std::string>& offListKeys();
[[nodiscard]] double offList(const std::string& key, const Place& at);

/// The student's viewing transformation by 4 x 4 matrices, as in the textbook, for flat faces. `mistake`
/// plants one of the mistakes of the view; `variant` is another convention that gives the same picture.

/// The picture; `cellOf` tells the cell of a face.
[[nodiscard]] Result drawByMatrices(const World& world, const Program& program,
                                    const std::function<int(int face)>& cellOf);
/// What the program takes for the normal of a face, and for a light, in viewing coordinates, turned back to
/// the world's.
[[nodiscard]] Triple normalInView(const World& world, const Program& program, const Triple& N);
[[nodiscard]] Triple lightInView(const World& world, const Program& program, const Triple& light,
                                 const Triple& P);

}  // namespace student
