#include "geometry/files/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/exact/scale.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

/// An option of map_Kd. The manual gives -o, -s and -t one to three numbers, and every other option one
/// count of words.
struct MapOption {
  std::string_view name;
  int least, most;                 ///< words that follow it; those beyond `least` only if they are numbers
  bool shows = true;               ///< whether it would change the picture
  std::string_view unlessIs = {};  ///< unless it is this
};
constexpr std::array kMapOptions{
    MapOption{"-blendu", 1, 1, false},
    MapOption{"-blendv", 1, 1, false},
    MapOption{"-bm", 1, 1, false},
    MapOption{"-boost", 1, 1, false},
    MapOption{"-texres", 1, 1, false},
    MapOption{"-cc", 1, 1, true, "off"},
    MapOption{"-clamp", 1, 1, true, "off"},
    MapOption{"-imfchan", 1, 1},
    MapOption{"-mm", 2, 2},
    MapOption{"-o", 1, 3},
    MapOption{"-s", 1, 3},
    MapOption{"-t", 1, 3},
};

bool isNumber(std::string_view word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  return std::from_chars(word.data(), end, value).ptr == end;
}

/// Reads the components after `Kd` or `Ks`. A missing green or blue equals the red. The first that is outside
/// of 0 to 1 is noted.
glm::dvec3 readColor(Words& words, std::string_view key, const std::string& name, std::string& outside) {
  glm::dvec3 color{1.0};
  for (int channel = 0; channel < 3; ++channel) {
    const std::string_view word = words.next();
    if (channel == 0 && (word == "spectral" || word == "xyz")) return color;
    if (channel == 0 && word.empty()) words.fail(std::string{key} + " needs a colour");
    const double value = word.empty() ? color.r : toNumber(words, word);
    color[channel] = std::clamp(value, 0.0, 1.0);
    if (outside.empty() && value != color[channel])
      outside = ParseError{name, words.line(),
                           std::string{key} + ' ' + std::string{word} + " is read as " +
                               (value > 1.0 ? "1" : "0") + ": a colour has numbers from 0 to 1"}
                    .what();
  }
  return color;
}

/// Reads the exponent after `Ns`.
int readExponent(Words& words) {
  const std::string_view word = words.next();
  if (word.empty()) words.fail("Ns needs a number");
  return static_cast<int>(std::lround(std::clamp(toNumber(words, word), 0.0, 1e6)));
}

/// True if a statement that has no place leaves the picture as it is: an opaque surface that does not shine.
bool hasNoEffect(std::string_view key, Words& words) {
  const double none = key == "d" ? 1.0 : 0.0;
  if (key != "d" && key != "Tr" && key != "Ke") return false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
    if (!isNumber(word) || toNumber(words, word) != none) return false;
  return true;
}

/// The file after `map_Kd` and its options -s and -o go into the material. Calls unsupported(name) for an
/// option that would change the picture.
template <class Unsupported>
void readMap(Words& words, MtlMaterial& material, const Unsupported& unsupported) {
  material.scale = glm::dvec2{1.0}, material.offset = glm::dvec2{0.0};
  std::string_view word = words.next();
  for (;;) {
    const auto* const option = std::ranges::find(kMapOptions, word, &MapOption::name);
    if (option == kMapOptions.end()) break;
    bool is = option->shows;
    int read = 0;
    glm::dvec2* const pair = option->name == "-s"   ? &material.scale
                             : option->name == "-o" ? &material.offset
                                                    : nullptr;
    for (word = words.next(); read < option->least || (read < option->most && isNumber(word)); ++read) {
      if (word.empty()) words.fail("map_Kd: nothing follows " + std::string{option->name});
      is = is && word != option->unlessIs;
      if (pair != nullptr && read < 2) (*pair)[read] = toNumber(words, word);
      word = words.next();
    }
    if (is && pair == nullptr) unsupported(option->name);
  }
  if (word.empty()) words.fail("map_Kd needs a file");
  const std::string first{word}, others = words.rest();
  material.map = others.empty() ? first : first + ' ' + others;
}

}  // namespace

MtlLibrary parseMtl(std::string_view text, const std::string& name) {
  MtlLibrary library;
  MtlMaterial* current = nullptr;
  std::set<MtlMaterial*> matte;  // without a highlight
  std::string outside;
  LeftOut leftOut;
  Words words{text, name};
  while (words.nextLine()) {
    const std::string_view key = words.next();
    if (key == "newmtl") {
      current = &library.materials.insert_or_assign(words.rest(), MtlMaterial{}).first->second;
      matte.erase(current);
    } else if (key == "Kd" && current) {
      current->Kd = readColor(words, key, name, outside);
    } else if (key == "Ks" && current) {
      current->Ks = readColor(words, key, name, outside);
    } else if (key == "Ns" && current) {
      current->Ns = readExponent(words);
    } else if (key == "illum" && current) {
      const std::string_view model = words.next();
      matte.erase(current);
      if (model == "0" || model == "1")
        matte.insert(current);
      else if (model != "2")
        leftOut.add(key);
    } else if (key == "map_Kd" && current) {
      current->line = words.line();
      readMap(words, *current, [&](std::string_view option) {
        if (library.notes.empty())
          library.notes.emplace_back(
              ParseError{name, words.line(), "map_Kd is read without " + std::string{option}}.what());
      });
    } else if (!key.empty() && current && !hasNoEffect(key, words)) {
      leftOut.add(key);
    }
  }
  if (!outside.empty()) library.notes.push_back(outside);
  for (MtlMaterial* const m : matte) m->Ks = glm::dvec3{0.0};
  if (const std::string what = leftOut.sentence(); !what.empty())
    library.notes.emplace_back(ParseError{name, 0, what}.what());
  return library;
}

namespace {

/// Numbers the names that faces use, in the order of their first use.
class NamesInUse {
 public:
  explicit NamesInUse(std::string name) : name_{std::move(name)} {}

  void select(std::string name) {
    name_ = std::move(name);
    number_ = -1;
  }
  /// The number of the selected name. A name gets its number when this is first called for it.
  [[nodiscard]] int number() {
    if (number_ < 0) {
      const auto [entry, isNew] = numbers_.try_emplace(name_, static_cast<int>(names_.size()));
      if (isNew) names_.push_back(name_);
      number_ = entry->second;
    }
    return number_;
  }
  [[nodiscard]] const std::string& selected() const { return name_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::string name_;
  int number_ = -1;  ///< number of name_, or -1 until it is asked for
  std::map<std::string, int> numbers_;
  std::vector<std::string> names_;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name, std::filesystem::path folder)
      : words_{text, name}, name_{name}, folder_{std::move(folder)} {}

  Mesh read() {
    while (words_.nextLine()) {
      const std::string_view key = words_.next();
      if (key == "v")
        readVertex();
      else if (key == "vt")
        readTexture();
      else if (key == "vn")
        readNormal();
      else if (key == "f")
        readFace();
      else if (key == "g" || key == "o")
        selectGroup();
      else if (key == "usemtl")
        material_.select(words_.rest());
      else if (key == "mtllib")
        readLibraries();
      else if (!key.empty())
        leftOut_.add(key);
    }
    checkForward(points_, mesh_.points.size());
    checkForward(texture_, mesh_.uv.size());
    takeNormals();
    if (mesh_.uvOfCorner.empty()) mesh_.uv.clear();
    if (mesh_.faceCount() == 0) words_.fail(0, "holds no face");
    mesh_.groupNames = group_.names();
    // Without a library all materials are white, and a missing library has its own note.
    bool told = libraries_.empty();
    for (const std::string& name : material_.names()) {
      const auto known = known_.find(name);
      if (known == known_.end() && !std::exchange(told, true))
        note(0, "no library has the material " + inQuotes(name) + ": it is white");
      mesh_.materials.push_back({.name = name});
      if (known == known_.end()) continue;
      const MtlMaterial& says = known->second.material;
      MeshMaterial& material = mesh_.materials.back();
      material.diffuse = says.Kd;
      material.specular = says.Ks.value_or(material.specular);
      material.n = says.Ns;
      if (says.map.empty()) continue;
      material.texture = textureOf(known->second);
      if (says.scale != glm::dvec2{1.0} || says.offset != glm::dvec2{0.0})
        moveTexture(static_cast<int>(mesh_.materials.size()) - 1, known->second);
    }
    mesh_.rounding.assign(mesh_.groupNames.size(), rounding_.rounding());
    for (const std::string& what : {leftOut_.sentence(), rounding_.doubtful()})
      if (!what.empty()) note(0, what);
    return std::move(mesh_);
  }

 private:
  void readVertex() {
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = words_.next();
      if (word.empty()) words_.fail("a vertex needs three coordinates");
      point[axis] = toNumber(words_, word);
      rounding_.add(word, point[axis]);
    }
    mesh_.points.push_back(point);
  }

  /// Reads one to three numbers. An absent v is 0; the depth is not used.
  void readTexture() {
    glm::dvec2 uv{0.0};
    for (int axis = 0; axis < 2; ++axis) {
      const std::string_view word = words_.next();
      if (word.empty() && axis == 0) words_.fail("a texture coordinate needs a number");
      if (!word.empty()) uv[axis] = toNumber(words_, word);
    }
    mesh_.uv.push_back(uv);
  }

  /// A normal without a direction counts as none.
  void readNormal() {
    glm::dvec3 N{0.0};
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = words_.next();
      if (word.empty()) words_.fail("a normal needs three coordinates");
      N[axis] = toNumber(words_, word, true);
    }
    normals_.push_back(unit(N));
  }

  /// A face may come before its normals, so they are taken at the end. Without one it can still be shown.
  void takeNormals() {
    normalOfCorner_.resize(normalOfCorner_.empty() ? 0 : mesh_.corners.size(), -1);
    bool lost = false;
    for (const int k : normalOfCorner_) {
      const bool there = k >= 0 && k < static_cast<int>(normals_.size());
      lost = lost || (k >= 0 && !there);
      mesh_.normals.push_back(there ? normals_[k] : glm::dvec3{0.0});
    }
    if (lost) note(0, "faces have normals that the file lacks: there they are computed");
  }

  void readFace() {
    const int line = words_.line();
    face_.clear();
    faceUv_.clear();
    bool textured = false;
    const std::size_t before = mesh_.corners.size();
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      const Corner corner = readCorner(word);
      face_.push_back(corner.point);
      faceUv_.push_back(corner.uv);
      textured |= corner.uv >= 0;
      if (corner.normal < 0) continue;
      normalOfCorner_.resize(before + face_.size(), -1);
      normalOfCorner_.back() = corner.normal;
    }
    if (face_.size() < 3) {
      words_.fail(line, "a face needs three vertices; this one has " + std::to_string(face_.size()));
    }
    if (!textured) faceUv_.clear();
    mesh_.addFace(face_, group_.number(), material_.selected().empty() ? -1 : material_.number(), faceUv_);
  }

  static constexpr int kNoNormal = std::numeric_limits<int>::max();  ///< stands for an index before the first

  struct Corner {
    int point, uv, normal;  ///< indices into Mesh::points, Mesh::uv and normals_; -1 for none
  };

  /// Reads one corner of a face.
  Corner readCorner(std::string_view corner) {
    const char* at = corner.data();
    const char* const end = at + corner.size();
    Corner result{place(readIndex(at, corner), points_, mesh_.points.size()), -1, -1};
    for (int slashes = 1; at != end; ++slashes) {
      if (*at != '/' || slashes > 2) failMalformed(corner);
      ++at;
      if (at == end || *at == '/') continue;
      const int index = readIndex(at, corner);
      if (slashes == 1) result.uv = place(index, texture_, mesh_.uv.size());
      if (slashes == 2) result.normal = index > 0 ? index - 1 : static_cast<int>(normals_.size()) + index;
      if (slashes == 2 && result.normal < 0) result.normal = kNoNormal;
    }
    return result;
  }

  /// Reads the index at `at`, inside `corner`, and moves `at` behind it.
  int readIndex(const char*& at, std::string_view corner) {
    const char* const end = corner.data() + corner.size();
    if (end - at > 1 && *at == '+' && at[1] != '-') ++at;  // std::from_chars does not accept '+'
    int index = 0;
    const auto [stop, error] = std::from_chars(at, end, index);
    if (error == std::errc::invalid_argument) failMalformed(corner);
    if (error == std::errc::result_out_of_range)
      words_.fail(outOfRange(inQuotes(corner), points_, "so far", mesh_.points.size()));
    if (index == 0) words_.fail("face index 0; OBJ counts from 1");
    at = stop;
    return index;
  }

  [[noreturn]] void failMalformed(std::string_view corner) const {
    words_.fail("malformed face index " + inQuotes(corner));
  }

  /// References to indices that are not yet read. An entry is kept only if its index is larger than all
  /// before it. This is enough: if any index is beyond the end, so is the largest, and the first bad one is
  /// larger than all before it.
  struct Forward {
    int index, line;
  };
  struct Indexed {
    const char* name;
    std::vector<Forward> forward;
  };

  /// The position from 0 that an index of a face means, when `read` entries have been read.
  int place(int index, Indexed& of, std::size_t read) {
    const int count = static_cast<int>(read);
    if (index < 0) {
      if (index < -count) words_.fail(outOfRange(std::to_string(index), of, "so far", read));
      return count + index;
    }
    if (index > count && (of.forward.empty() || index > of.forward.back().index)) {
      of.forward.push_back({index, words_.line()});
    }
    return index - 1;
  }

  /// A face may come before its vertices. Only the end of the file tells whether they exist.
  void checkForward(const Indexed& of, std::size_t read) const {
    const auto bad = std::ranges::find_if(
        of.forward, [&](const Forward& reference) { return reference.index > static_cast<int>(read); });
    if (bad != of.forward.end())
      words_.fail(bad->line, outOfRange(std::to_string(bad->index), of, "in the file", read));
  }

  static std::string outOfRange(const std::string& index, const Indexed& of, const char* where,
                                std::size_t read) {
    return "face index " + index + " is out of range; " + of.name + " " + where + ": " + std::to_string(read);
  }

  void selectGroup() {
    const std::string name = words_.rest();
    group_.select(name.empty() ? kDefaultGroup : name);
  }

  /// Reads the libraries of a line. If two libraries have a material, the first one counts. The whole rest of
  /// the line is tried as one name before its words are tried.
  void readLibraries() {
    const std::string names = words_.rest();
    if (readLibrary(folder_ / names)) return;
    Words each{names, {}};
    each.nextLine();
    bool any = false;
    std::string lost;  // the first that is missing
    for (std::string name{each.next()}; !name.empty(); name = each.next()) {
      if (readLibrary(namedFile(folder_, name)))
        any = true;
      else if (lost.empty())
        lost = name;
    }
    const std::filesystem::path file = namedFile(folder_, any ? lost : names);
    if (!lost.empty() && !readLibrary(file) && !std::exchange(missing_, true))
      note(words_.line(), "material library '" + visible(file.string()) +
                              "' not found; materials defined only there are white");
  }

  struct Known {
    MtlMaterial material;
    std::filesystem::path library;
  };

  /// The index of the material's texture.
  int textureOf(const Known& known) {
    const std::string file = namedFile(known.library.parent_path(), known.material.map).string();
    std::vector<TextureFile>& all = mesh_.textureFiles;
    const auto same = std::ranges::find(all, file, &TextureFile::file);
    const auto index = static_cast<int>(same - all.begin());
    if (same == all.end()) all.push_back({file, known.library.string(), known.material.line});
    return index;
  }

  /// Applies -s and -o of map_Kd to the texture coordinates of a material's faces. Each gets its own: another
  /// material may share the old ones.
  void moveTexture(int material, const Known& by) {
    if (mesh_.uvOfCorner.empty()) return;
    std::map<int, int> moved;
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      if (mesh_.material[f] != material) continue;
      for (int c = mesh_.firstCorner[f]; c < mesh_.firstCorner[f + 1]; ++c) {
        int& uv = mesh_.uvOfCorner[c];
        if (uv < 0) continue;
        const auto [entry, isNew] = moved.try_emplace(uv, static_cast<int>(mesh_.uv.size()));
        if (isNew) mesh_.uv.push_back(by.material.scale * mesh_.uv[uv] + by.material.offset);
        if (!std::isfinite(mesh_.uv[entry->second].x) || !std::isfinite(mesh_.uv[entry->second].y))
          throw ParseError{by.library.string(), by.material.line,
                           "map_Kd moves the texture out of all numbers"};
        uv = entry->second;
      }
    }
  }

  void note(int line, const std::string& what) {
    mesh_.notes.emplace_back(ParseError{name_, line, what}.what());
  }

  /// Returns false if there is no such file.
  bool readLibrary(const std::filesystem::path& file) {
    std::error_code missing;
    if (!std::filesystem::is_regular_file(file, missing)) return false;
    if (!libraries_.insert(file).second) return true;
    MtlLibrary library = parseMtl(readTextFile(file), file.string());
    for (auto& [material, says] : library.materials)
      known_.try_emplace(material, Known{std::move(says), file});
    std::ranges::move(library.notes, std::back_inserter(mesh_.notes));
    return true;
  }

  inline static const std::string kDefaultGroup = "default";

  Words words_;
  std::string name_;
  std::filesystem::path folder_;
  Mesh mesh_;
  NamesInUse group_{kDefaultGroup};
  NamesInUse material_{""};  ///< the empty name stands for no material
  std::map<std::string, Known> known_;
  bool missing_ = false;  ///< whether a note tells of a missing library
  /// Already read: some writers name the library before every object.
  std::set<std::filesystem::path> libraries_;
  Indexed points_{"vertices", {}}, texture_{"texture coordinates", {}};
  std::vector<glm::dvec3> normals_;  ///< every `vn`
  std::vector<int> normalOfCorner_;  ///< of the corners up to the last that has one, index into normals_
  std::vector<int> face_, faceUv_;   ///< of the current face; members to reuse their memory
  LeftOut leftOut_;
  RoundingOfNumbers rounding_;
};

}  // namespace

Mesh parseObj(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
  return ObjReader{text, name, folder}.read();
}

Mesh readObj(const std::filesystem::path& file) {
  return parseObj(readTextFile(file), file.string(), file.parent_path());
}

}  // namespace xnewell
