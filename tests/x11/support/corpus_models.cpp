#include "tests/x11/support/corpus_models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/ply_text.h"

namespace xnewell {

namespace {

using Shape = CorpusModel::Shape;

std::string decimal(double v) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", v);
  return text;
}

Shape boxShape() {
  Shape s;
  for (int i = 0; i < 8; ++i) s.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  s.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return s;
}

/// A closed solid between z = 0 and z = 1 over an outline, counter-clockwise. Consecutive equal points of a
/// bridge make no wall.
Shape prism(const std::vector<std::array<double, 2>>& outline, bool bridged = false) {
  const int n = static_cast<int>(outline.size());
  Shape s;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : outline) s.points.push_back({x, y, z});
  std::vector<int> low, high;
  for (int i = 0; i < n; ++i) low.push_back(n - 1 - i), high.push_back(n + i);
  s.faces = {low, high};
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    // The bridge goes from corner n/2 - 1 to the hole and back from the last corner.
    if (!bridged || (i != n / 2 - 1 && i != n - 1)) s.faces.push_back({i, next, n + next, n + i});
  }
  return s;
}

std::string vertices(const Shape& s, double unit = 1.0, const std::string& end = "\n") {
  std::string text;
  for (const auto& p : s.points)
    text += "v " + decimal(p[0] * unit) + ' ' + decimal(p[1] * unit) + ' ' + decimal(p[2] * unit) + end;
  return text;
}

/// `f` lines. `base` is what index 0 is written as.
std::string faces(const Shape& s, int base = 1, const std::string& end = "\n") {
  std::string text;
  for (const std::vector<int>& face : s.faces) {
    text += 'f';
    for (const int i : face) text += ' ' + std::to_string(i + base);
    text += end;
  }
  return text;
}

PlyText plyOfBox() {
  const Shape s = boxShape();
  PlyText ply{.declared =
                  "comment VCGLIB generated\nelement vertex 8\nproperty float x\nproperty float y\n"
                  "property float z\nproperty uchar red\nelement face 6\n"
                  "property list uchar int vertex_indices\n",
              .values = {},
              .perLine = {4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5}};
  for (const auto& p : s.points) {
    for (const double v : p) ply.values.push_back({'f', v});
    ply.values.push_back({'B', 200});
  }
  for (const std::vector<int>& face : s.faces) {
    ply.values.push_back({'B', double(face.size())});
    for (const int i : face) ply.values.push_back({'i', double(i)});
  }
  return ply;
}

/// The sides as strips of two triangles, and the normals of points that the program takes for shading.
std::string plyOfStrips(Shape& s) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 8\n", strips;
  for (const char* const name : {"x", "y", "z", "nx", "ny", "nz"})
    text += "property float " + std::string{name} + "\n";
  text += "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  for (const auto& p : s.points) {
    for (const double v : p) text += decimal(v) + ' ';
    for (const double v : p) text += decimal(2 * v - 1) + ' ';
    text += '\n';
  }
  std::vector<std::vector<int>> triangles;
  for (const std::vector<int>& f : s.faces) {
    for (const int k : {f[0], f[1], f[3], f[2]}) strips += ' ' + std::to_string(k);
    strips += " -1";
    triangles.push_back({f[0], f[1], f[3]}), triangles.push_back({f[3], f[1], f[2]});
  }
  s.faces = triangles;
  return text + "30" + strips + '\n';
}

std::string offOfBox() {
  const Shape s = boxShape();
  std::string text = "COFF # with colours\n8 6 12\n\n";
  for (const auto& p : s.points)
    text += decimal(p[0]) + ' ' + decimal(p[1]) + ' ' + decimal(p[2]) + " 255 128 0 255\n";
  for (const std::vector<int>& face : s.faces) {
    text += std::to_string(face.size());
    for (const int i : face) text += ' ' + std::to_string(i);
    text += "\n# a face\n";
  }
  return text;
}

/// Each face has vertices of its own, counted back from the last.
std::string negativeObj(const Shape& s) {
  std::string text;
  for (const std::vector<int>& face : s.faces) {
    Shape own;
    for (const int i : face) own.points.push_back(s.points[i]);
    own.faces = {{}};
    for (int k = 0; k < std::ssize(face); ++k) own.faces[0].push_back(k);
    text += vertices(own) + faces(own, -static_cast<int>(face.size()));
  }
  return text;
}

/// A grid of saddles: no face is planar.
Shape saddles() {
  Shape s;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) s.points.push_back({double(i), double(j), i * j / 8.0});
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) s.faces.push_back({4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4});
  return s;
}

}  // namespace

std::vector<CorpusModel> corpusModels() {
  const Shape box = boxShape();
  std::vector<std::array<double, 2>> wheel, star;
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5 * i + 0.02 * i * i / 12.0, r = i % 2 ? 0.4 : 1.0;
    wheel.push_back({std::cos(angle), std::sin(angle)});
    star.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const Shape manyCorners = prism(wheel), concave = prism(star);
  const Shape frame =
      prism({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}, true);

  std::string groups = "# Blender\nmtllib gone.mtl\no Cube\n" + vertices(box) + "vn 0 0 1\ns off\n";
  for (std::size_t f = 0; f < box.faces.size(); ++f) {
    Shape one;
    one.faces = {box.faces[f]};
    groups += "g side " + std::to_string(f % 3) + "\nusemtl m\n" + faces(one);
  }
  groups += "l 1 2\nl 2 3\np 1\n";

  std::string crLf = "\xEF\xBB\xBF# made elsewhere\r\n" + vertices(box, 1, "\r\n") + faces(box, 1, "\r\n");
  for (std::size_t at = crLf.find("f "); at != crLf.npos; at = crLf.find("\r\nf ", at + 9))
    crLf.insert(crLf.find(' ', at + 4), " \\\r\n ");

  std::string cr = vertices(box) + faces(box), normals = vertices(box) + "vn 0 0 1\nvn 1 0 0\n" + faces(box);
  std::ranges::replace(cr, '\n', '\r');
  for (std::size_t at = normals.find("f "); at != normals.npos; at = normals.find("\nf ", at + 1))
    normals.insert(normals.find(' ', at + 3), "//2");

  Shape turned = box, open = box, strips = box;
  const std::string plyStrips = plyOfStrips(strips);
  turned.faces[3] = {3, 7, 6, 2};
  open.faces.pop_back();

  const std::string noLibrary =
      ":2: material library 'FOLDER/gone.mtl' not found; materials defined only there are white";
  return {
      {"groups.obj", groups, box, 0, 0, 0, {noLibrary, ": the program does not use s, l, p"}},
      {"negative.obj", negativeObj(box), box},
      {"ngons.obj", vertices(manyCorners) + faces(manyCorners), manyCorners},
      {"crlf.obj", crLf, box},
      {"cr.obj", cr, box},
      {"normals.obj", normals, box},
      {"strips.ply", plyStrips, strips},
      {"huge.obj", vertices(box, 1e300) + faces(box), box},
      {"tiny.obj", vertices(box, 1e-300) + faces(box), box},
      {"bridged.obj", vertices(frame) + faces(frame), frame},
      {"concave.obj", vertices(concave) + faces(concave), concave},
      {"bent.obj",
       vertices(saddles()) + faces(saddles()),
       saddles(),
       12,
       0,
       0,
       {": 9 faces, the first is face 0, are bent: their corners lie in no plane, so they are cut into "
        "triangles"}},
      {"wrong.obj", vertices(turned) + faces(turned), turned, 0, 4},
      {"open.obj", vertices(open) + faces(open), open, 4},
      {"binary.ply",
       plyOfBox().as(PlyForm::LittleEndian),
       box,
       0,
       0,
       0,
       {": the program does not use vertex.red"}},
      {"text.ply", plyOfBox().as(PlyForm::Text), box, 0, 0, 0, {": the program does not use vertex.red"}},
      {"colours.off", offOfBox(), box, 0, 0, 0, {": the program does not use colours of points"}},
  };
}

std::string hillObj(int n) {
  std::string text;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      text += "v " + std::to_string(i) + ' ' + std::to_string(j) + ' ' +
              decimal(2.0 * (i * (n - i) + j * (n - j)) / n) + '\n';
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      text += 'f';
      for (const int k :
           {j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i})
        text += ' ' + std::to_string(k + 1);
      text += '\n';
    }
  return text;
}

}  // namespace xnewell
