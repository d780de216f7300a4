#include "tests/x11/support/malformed_files.h"

#include "shading/color/png.h"

namespace xnewell {

namespace {

std::string objOf(const std::string& more) { return "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + more; }
std::string mtlOf(const std::string& more) { return "newmtl m\n" + more; }
std::string offOf(const std::string& more) { return "OFF\n3 1 0\n0 0 0\n1 0 0\n" + more; }
/// A header for three vertices and one face, with some of its lines replaced; lines 1 to 9.
std::string plyOf(const std::string& form, const std::string& vertex = "element vertex 3",
                  const std::string& z = "property float z",
                  const std::string& list = "property list uchar int vertex_indices") {
  return "ply\nformat " + form + " 1.0\n" + vertex + "\nproperty float x\nproperty float y\n" + z +
         "\nelement face 1\n" + list + "\nend_header\n";
}
const std::string kPly = plyOf("ascii"), kBinary = plyOf("binary_little_endian");
std::string zeros(std::size_t bytes) { return std::string(bytes, '\0'); }
/// A patch of 18 lines, with its last line replaced.
std::string bptOf(const std::string& last, const std::string& degrees = "3 3") {
  std::string text = "1\n" + degrees + "\n";
  for (int i = 0; i < 15; ++i) text += "0 0 1\n";
  return text + last + "\n";
}
std::string sceneOf(const std::string& object) { return R"({"objects": [{)" + object + "}]}"; }
std::string lessonOf(const std::string& step) { return R"({"title": "t", "steps": [{)" + step + "}]}"; }
std::string pngOf(const std::string& note) { return encodePng(IndexImage{3, 2, 7}, Palette{}, note); }

}  // namespace

std::vector<Malformed> malformedFiles() {
  return {
      {"a.obj", "", ": holds no face"},
      {"a.obj",
       "\x7f"
       "ELF\x01\x02\n",
       ": holds no face"},
      {"a.obj", objOf(""), ": holds no face"},
      {"a.obj", objOf("f 0 1 2\n"), ":4: face index 0; OBJ counts from 1"},
      {"a.obj", objOf("f 1 2 4\n"), ":4: face index 4 is out of range; vertices in the file: 3"},
      {"a.obj", objOf("f 1 2 -4\n"), ":4: face index -4 is out of range; vertices so far: 3"},
      {"a.obj", objOf("f 1 2\n"), ":4: a face needs three vertices; this one has 2"},
      {"a.obj", objOf("f 1/1 2/2 3/3\n"),
       ":4: face index 1 is out of range; texture coordinates in the file: 0"},
      {"a.obj", objOf("f 1 2 99999999999999\n"),
       ":4: face index '99999999999999' is out of range; vertices so far: 3"},
      {"a.obj", objOf("f 1 2 3.5\n"), ":4: malformed face index '3.5'"},
      {"a.obj", "v 0 nan 0\n", ":1: number 'nan' is not finite"},
      {"a.obj", "\r\nv 0 -inf 0\r\n", ":2: number '-inf' is not finite"},
      {"a.obj", "v 1e999 0 0\n", ":1: number '1e999' is too large"},
      {"a.obj", "v 1 \\\n2,5 3\n", ":2: malformed number '2,5'"},

      {"a.obj", "\xFF\xFEv" + zeros(1) + " " + zeros(1), ": a text in UTF-16; save it as UTF-8"},
      {"a.ply", "\xFE\xFF" + zeros(1) + "p", ": a text in UTF-16; save it as UTF-8"},

      {"a.mtl", mtlOf("Kd 1 x 0\n"), ":2: malformed number 'x'"},
      {"a.mtl", mtlOf("Kd\n"), ":2: Kd needs a colour"},
      {"a.mtl", mtlOf("Kd nan 0 0\n"), ":2: number 'nan' is not finite"},
      {"a.mtl", mtlOf("Ks\n"), ":2: Ks needs a colour"},
      {"a.mtl", mtlOf("Ns\n"), ":2: Ns needs a number"},
      {"a.mtl", mtlOf("Ns -nan\n"), ":2: number '-nan' is not finite"},
      {"a.mtl", mtlOf("map_Kd\n"), ":2: map_Kd needs a file"},
      {"a.mtl", mtlOf("map_Kd -o x a.png\n"), ":2: malformed number 'x'"},
      {"a.mtl", mtlOf("map_Kd -mm 1\n"), ":2: map_Kd: nothing follows -mm"},

      {"a.ply", "", ":1: the file does not begin with ply"},
      {"a.ply", "plyx\nend_header\n", ":1: the file does not begin with ply"},
      {"a.ply", "ply\nformat ascii 1.0\n", ": the header has no end: there is no line end_header"},
      {"a.ply", "ply\nend_header\n", ": the header has no line format"},
      {"a.ply", "ply\nformat ascii 2.0\nend_header\n", ":2: version '2.0'; only 1.0 is read"},
      {"a.ply", plyOf("utf8"), ":2: 'utf8' is not one of ascii, binary_little_endian, binary_big_endian"},
      {"a.ply", plyOf("ascii", "element vertex"), ":3: the number of elements is missing"},
      {"a.ply", plyOf("ascii", "element vertex -3"),
       ":3: the number of elements '-3' is not within 0 to 2147483647"},
      {"a.ply", plyOf("ascii", "element vertex 99999999999"),
       ":3: the number of elements '99999999999' is not within 0 to 2147483647"},
      {"a.ply", plyOf("ascii", "elements vertex 3"), ":3: unknown statement 'elements' in the header"},
      {"a.ply", plyOf("ascii", "comment"), ":4: a property stands before the first element"},
      {"a.ply", plyOf("ascii", "element face 3"), ":7: the element 'face' is declared twice"},
      {"a.ply", plyOf("ascii", "element edge 1\nelement vertex 3"), ":3: the element 'edge' has no property"},
      {"a.ply", plyOf("ascii", "element vertex 3", "property real z"), ":6: unknown type 'real'"},
      {"a.ply", plyOf("ascii", "element vertex 3", "property float y"),
       ":6: the property 'y' is declared twice"},
      {"a.ply", plyOf("ascii", "element vertex 3", "property float w"),
       ":3: the element vertex has no number z"},
      {"a.ply", plyOf("ascii", "element vertex 3", "property float z", "property int vertex_indices"),
       ":7: the element face has no list vertex_indices"},
      {"a.ply",
       plyOf("ascii", "element vertex 3", "property float z", "property list float int vertex_indices"),
       ":8: the length of a list is a whole number"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement tristrips 0\nproperty list int int vertex_indices\nend_header\n",
       ": the header has no element vertex"},
      {"a.ply", kPly + "0 0 0\n1 0 0\n", ":11: the file ends before vertex 3 of 3"},
      {"a.ply", kPly + "0 0 0\n1 0\n", ":11: the line of vertex 2 of 3 ends early"},
      {"a.ply", kPly + "0 0 0\n1 0 0 0\n", ":11: unexpected '0'"},
      {"a.ply", kPly + "0 0 0\n1 inf 0\n", ":11: y is not finite"},
      {"a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ":13: a vertex index is 3; vertices: 3"},
      {"a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", ":13: a vertex index is 1.500000; vertices: 3"},
      {"a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", ":13: the length of a list is -3"},
      {"a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n",
       ": holds no face; 1 face has fewer than three corners"},
      {"a.ply", kPly + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n7\n", ":14: unexpected '7' after the last element"},
      {"a.ply", kBinary + zeros(35),
       ": vertex 3 of 3: the file ends here, after " + std::to_string(kBinary.size() + 35) + " bytes"},
      {"a.ply", plyOf("binary_little_endian", "element vertex 2147483647") + zeros(12),
       ": vertex 2 of 2147483647: the file ends here, after 190 bytes"},
      {"a.ply",
       plyOf("binary_big_endian", "element vertex 3", "property float z",
             "property list uint int vertex_index") +
           zeros(36) + "\xff\xff\xff\xff",
       ": face 1 of 1: the file ends here, after 203 bytes"},
      {"a.ply", kBinary + zeros(36) + "\x03" + zeros(8) + "\xff\xff\xff\xff",
       ": face 1 of 1: a vertex index is -1; vertices: 3"},
      {"a.ply", kBinary + zeros(34) + "\x80\x7f", ": vertex 3 of 3: z is not finite"},
      {"a.ply", kBinary + zeros(36) + "\x03" + zeros(13), ": 1 bytes follow the last element"},

      {"a.off", "", ": holds no face"},
      {"a.off", "# OFF\n3 1 0\n", ":2: the file begins with '3', not with OFF"},
      {"a.off", "OFF BINARY\n", ":1: the file is a binary OFF file, and only text is read"},
      {"a.off", "4OFF\n1 1 0\n", ":1: '4OFF': the points have other than three coordinates"},
      {"a.off", "OFF\n", ":1: the number of points is missing"},
      {"a.off", "OFF\n3\n", ":2: the number of faces is missing"},
      {"a.off", "OFF\n-3 1 0\n", ":2: malformed number of points '-3'"},
      {"a.off", "OFF 99999999999 1\n", ":1: malformed number of points '99999999999'"},
      {"a.off", "OFF 2147483647 2147483647 0\n0 0 0\n", ":2: the file ends before point 2 of 2147483647"},
      {"a.off", offOf("0 1\n"), ":5: a point needs three coordinates"},
      {"a.off", offOf("0 1 0 0\n"), ":5: a point of OFF does not have 4 numbers"},
      {"a.off", offOf("0 1 z\n"), ":5: malformed number 'z'"},
      {"a.off", offOf("0 1 0\n"), ":5: the file ends before face 1 of 1"},
      {"a.off", offOf("0 1 0\n3 0 1\n"), ":6: the face has 2 of 3 corners"},
      {"a.off", offOf("0 1 0\n3 0 1 3\n"), ":6: index 3 is out of range; points: 3"},
      {"a.off", offOf("0 1 0\n3 0 1 -1\n"), ":6: index -1 is out of range; points: 3"},
      {"a.off", offOf("0 1 0\nx\n"), ":6: malformed number of corners 'x'"},
      {"a.off", offOf("0 1 0\n2147483647 0 1 2\n"), ":6: the face has 3 of 2147483647 corners"},
      {"a.off", offOf("0 1 0\n3 0 1 2 0.5 0.5\n"), ":6: a colour has 1, 3 or 4 numbers; this one has 2"},
      {"a.off", offOf("0 1 0\n3 0 1 2\n3 0 1 2\n"), ":7: unexpected '3' after the last face"},

      {"a.bpt", "", ": holds no patch"},
      {"a.bpt", "1000001\n", ":1: number of patches '1000001' is not within 1 to 1000000"},
      {"a.bpt", "1\n3 3\n0 0 0\n", ":3: the file ends inside patch 1 of 1"},
      {"a.bpt", "1000000\n", ":1: the file ends before patch 1 of 1000000"},
      {"a.bpt", bptOf("0 0 1", "3 2"), ":2: degrees '3' and '2'; a patch here is bicubic, 3 3"},
      {"a.bpt", bptOf("0 0"), ":18: a control point needs three coordinates"},
      {"a.bpt", bptOf("0 0 1 1"), ":18: unexpected '1'"},

      {"s.json", "", ":1: not valid JSON here"},
      {"s.json", "{\"objects\": [\n1,,\n]}", ":2: not valid JSON here"},
      {"s.json", "{\"objects\": [\n  {\"solid\": \"cube\"\n\n]\n}\n", ":2: this { is not closed"},
      {"s.json", "{\"objects\": [\n  {\"solid\": \"cube\"}\n],\n\"camera\": {\"fov\": 30}\n\n\n",
       ":1: this { is not closed"},
      {"s.json", "{}", ": the scene has no faces"},
      {"s.json", std::string(100'000, '['), ":1: lists and objects are nested more than 100 deep"},
      {"s.json", std::string(100, '[') + std::string(100, ']'), ": an object { } is needed"},
      {"s.json", sceneOf(""), ": objects[0]: exactly one of file, polygons and solid is needed"},
      {"s.json", sceneOf(R"("file": "x.txt")"),
       ": objects[0].file: a model file is needed: .obj, .ply, .off, .bpt"},
      {"s.json", sceneOf(R"("file": "gone.off")"), ": objects[0].file: 'gone.off': No such file or directory",
       1},
      {"s.json", sceneOf(R"("solid": "torus", "around": 5000)"),
       ": objects[0].around: a whole number from 3 to 4096 is needed"},
      {"s.json", sceneOf(R"("polygons": [[[1e999,0,0],[1,0,0],[1,1,0]]])"), ":1: a number is too large"},
      {"s.json", sceneOf(R"("solid": "cube", "solid": "cube")"),
       ":1: the key 'solid' appears twice in an object"},

      {"l.json", "[]", ": an object { } is needed"},
      {"l.json", lessonOf(R"("heading": "h")"), ": steps[0]: caption is needed"},
      {"l.json", lessonOf(R"("heading": "h", "caption": ["c"], "scene": "none")"),
       ": steps[0].scene: 'none' is no built-in scene, and no file beside the lesson"},
      {"l.json", R"({"title": "t", "steps": []})", ": steps: 1 to 12 steps are needed"},

      {"p.png", "", ": not a PNG file"},
      {"p.png", "hello", ": not a PNG file"},
      {"p.png", pngOf("xnewell draw cubes").substr(0, 100), ": the PNG file ends early"},
      {"p.png", pngOf(""), ": the picture carries no set-up, so it is no scene"},
      {"p.png", pngOf("xnewell draw cubes --ids b.png -o picture.png"), ": a picture cannot carry '--ids'"},
      {"p.png", pngOf("xnewell draw 'cubes -o picture.png"),
       ": the set-up that it carries is no command of xnewell"},
      {"p.png", pngOf("xnewell draw te\xFFpot -o picture.png"), ": the set-up that it carries is not UTF-8"},
      {"p.png", pngOf("xnewell draw gone.ply -o picture.png"),
       ": the scene of the set-up that it carries, gone.ply, is not there"},
  };
}

}  // namespace xnewell
