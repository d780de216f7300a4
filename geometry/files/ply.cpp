#include "geometry/files/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/files/indexed_faces.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

/// The header up to and with the end of its last line. Comments are blank: a backslash at the end of one must
/// not join the next line. Empty if there is no line `end_header`.
std::string plyHeaderText(std::string_view text) {
  std::string header;
  // The first line tells how lines end: an LF after the last CR may be data.
  const std::size_t first = text.find_first_of("\r\n");
  if (first == text.npos) return "";
  const char ends = text.substr(first, 2) == "\r\n" ? '\n' : text[first];
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(ends, at), text.size() - 1) + 1;
    const std::string_view line = text.substr(at, end - at);
    const auto is = [&](std::string_view word) {
      return line.starts_with(word) && line.find_first_not_of(" \t\r\n", word.size()) == line.npos;
    };
    if (line.starts_with("comment") || line.starts_with("obj_info")) {
      header.append(line.size() - 1, ' ') += line.back();
    } else {
      header += line;
      if (is("end_header")) return header;
    }
    at = end;
  }
  return "";
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(const std::string& header, const std::string& name) : words_{header, name} {}

  PlyHeader read() {
    PlyHeader header;
    if (words_.firstOfNextLine() != "ply") words_.fail("the file does not begin with ply");
    words_.expectEndOfLine();
    bool form = false;
    for (std::string_view key = words_.firstOfNextLine(); key != "end_header";
         key = words_.firstOfNextLine()) {
      if (key == "format")
        header.form = readForm(), form = true;
      else if (key == "element")
        header.elements.push_back(readElement(header));
      else if (key == "property")
        readProperty(header);
      else
        words_.fail("unknown statement " + inQuotes(key) + " in the header");
      words_.expectEndOfLine();
    }
    if (!form) words_.fail(0, "the header has no line format");
    for (const PlyElement& e : header.elements)
      if (e.properties.empty()) words_.fail(e.line, "the element " + inQuotes(e.name) + " has no property");
    header.lines = words_.line();
    return header;
  }

 private:
  std::string_view word(const char* what) {
    const std::string_view next = words_.next();
    if (next.empty()) words_.fail(std::string{what} + " is missing");
    return next;
  }

  PlyForm readForm() {
    const std::string_view form = word("the format"), version = word("the version");
    if (version != "1.0") words_.fail("version " + inQuotes(version) + "; only 1.0 is read");
    if (form == "ascii") return PlyForm::Text;
    if (form == "binary_little_endian") return PlyForm::LittleEndian;
    if (form == "binary_big_endian") return PlyForm::BigEndian;
    words_.fail(inQuotes(form) + " is not one of ascii, binary_little_endian, binary_big_endian");
  }

  PlyElement readElement(const PlyHeader& header) {
    const std::string name{word("the element's name")};
    const std::string_view number = word("the number of elements");
    int count = 0;
    const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), count);
    if (stop != number.data() + number.size() || error != std::errc{} || count < 0)
      words_.fail("the number of elements " + inQuotes(number) + " is not within 0 to 2147483647");
    if (std::ranges::find(header.elements, name, &PlyElement::name) != header.elements.end())
      words_.fail("the element " + inQuotes(name) + " is declared twice");
    checkRoom(header.elements.size(), "elements");
    return {name, count, {}, words_.line()};
  }

  PlyNumber readNumber() {
    const std::string_view type = word("the property's type");
    for (const PlyNumberRow& row : kPlyNumbers)
      if (type == row.name || type == row.other) return row.id;
    words_.fail("unknown type " + inQuotes(type));
  }

  void readProperty(PlyHeader& header) {
    if (header.elements.empty()) words_.fail("a property stands before the first element");
    PlyElement& element = header.elements.back();
    PlyProperty property;
    Words ahead = words_;
    property.list = ahead.next() == "list";
    if (property.list) {
      (void)words_.next();
      property.length = readNumber();
      if (!rowOf(property.length).whole) words_.fail("the length of a list is a whole number");
    }
    property.number = readNumber();
    property.name = word("the property's name");
    if (element.find(property.name) >= 0)
      words_.fail("the property " + inQuotes(property.name) + " is declared twice");
    checkRoom(element.properties.size(), "properties");
    element.properties.push_back(std::move(property));
  }

  void checkRoom(std::size_t names, const char* of) const {
    if (names >= kMostPlyNames) words_.fail("more than " + std::to_string(kMostPlyNames) + ' ' + of);
  }

  Words words_;
};

}  // namespace

int PlyElement::find(std::string_view property) const {
  const auto at = std::ranges::find(properties, property, &PlyProperty::name);
  return at == properties.end() ? -1 : static_cast<int>(at - properties.begin());
}

PlyHeader parsePlyHeader(std::string_view text, const std::string& name) {
  if (!text.starts_with("ply")) Words{text, name}.fail(1, "the file does not begin with ply");
  const std::string lines = plyHeaderText(text);
  if (lines.empty()) Words{text, name}.fail(0, "the header has no end: there is no line end_header");
  PlyHeader header = PlyHeaderReader{lines, name}.read();
  header.bytes = lines.size();
  return header;
}

namespace {

template <class T, class Bits>
double valueOf(Bits bits) {
  return static_cast<double>(std::bit_cast<T>(bits));
}

class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& name)
      : header_{parsePlyHeader(text, name)},
        data_{text.substr(header_.bytes)},
        words_{data_, name, header_.lines},
        name_{name} {}

  Mesh read() {
    const PlyElement *const vertex = element("vertex"), *const face = element("face"),
                            *const strips = element("tristrips");
    for (const PlyElement& e : header_.elements)
      if (&e != vertex && &e != face && &e != strips) leftOut_.add(e.name);
    if (!face && !strips) {
      const std::string others = leftOut_.sentence();
      words_.fail(0, others.empty() ? "holds no face" : "holds no face; " + others);
    }
    if (!vertex) words_.fail(0, "the header has no element vertex");
    findUsed(*vertex);
    for (const PlyElement* const e : {face, strips})
      if (e) (void)indicesOf(*e);
    vertexCount_ = vertex->count;
    for (const PlyElement& e : header_.elements) {
      if (&e == vertex)
        readVertices(e);
      else if (&e == face || &e == strips)
        readFaces(e, &e == strips);
      else
        readRows(e, {}, [] {});
    }
    expectEnd();
    Mesh mesh = faces_.take(name_, roundingOf(*vertex));
    for (const std::string& what : {leftOut_.sentence(), text() ? rounding_.doubtful() : ""})
      if (!what.empty()) mesh.notes.emplace_back(ParseError{name_, 0, what}.what());
    return mesh;
  }

 private:
  [[nodiscard]] bool text() const { return header_.form == PlyForm::Text; }

  [[nodiscard]] const PlyElement* element(std::string_view name) const {
    const auto at = std::ranges::find(header_.elements, name, &PlyElement::name);
    return at == header_.elements.end() ? nullptr : &*at;
  }

  /// The places of properties that are numbers; none if one of them is missing.
  static std::vector<int> numbersOf(const PlyElement& e, const std::vector<std::string_view>& names) {
    std::vector<int> places;
    for (const std::string_view name : names) {
      const int at = e.find(name);
      if (at < 0 || e.properties[at].list) return {};
      places.push_back(at);
    }
    return places;
  }

  /// Finds the properties that are used, before any data is read.
  void findUsed(const PlyElement& vertex) {
    for (const std::string_view axis : {"x", "y", "z"}) {
      const std::vector<int> at = numbersOf(vertex, {axis});
      if (at.empty()) words_.fail(vertex.line, "the element vertex has no number " + std::string{axis});
      xyz_.push_back(at[0]);
    }
    uv_ = numbersOf(vertex, {"u", "v"});
    if (uv_.empty()) uv_ = numbersOf(vertex, {"s", "t"});
    if (uv_.empty()) uv_ = numbersOf(vertex, {"texture_u", "texture_v"});
    normal_ = numbersOf(vertex, {"nx", "ny", "nz"});
  }

  /// The place of the list of vertices.
  [[nodiscard]] int indicesOf(const PlyElement& e) const {
    int at = e.find("vertex_indices");
    if (at < 0) at = e.find("vertex_index");
    if (at < 0 || !e.properties[at].list)
      words_.fail(e.line, "the element " + e.name + " has no list vertex_indices");
    return at;
  }

  void readVertices(const PlyElement& e) {
    std::vector<int> used = xyz_;
    used.insert(used.end(), uv_.begin(), uv_.end());
    used.insert(used.end(), normal_.begin(), normal_.end());
    readRows(e, used, [&] {
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = finite(e, xyz_[axis]);
        largest_ = std::max(largest_, std::abs(point[axis]));
        if (text()) rounding_.add(spelled_[xyz_[axis]], point[axis]);
      }
      faces_.mesh.points.push_back(point);
      if (!uv_.empty()) faces_.mesh.uv.emplace_back(finite(e, uv_[0]), finite(e, uv_[1]));
      if (!normal_.empty())
        faces_.normals.emplace_back(values_[normal_[0]], values_[normal_[1]], values_[normal_[2]]);
    });
  }

  /// An element is a face, or strips of triangles: each vertex after the first two makes a triangle with the
  /// two before it, and every second one is turned. An index -1 ends a strip. Two equal corners join strips.
  void readFaces(const PlyElement& e, bool strips) {
    const std::vector<int> rgb = numbersOf(e, {"red", "green", "blue"});
    std::vector<int> used = rgb;
    used.push_back(indicesOf(e));
    readRows(e, used, [&] {
      std::optional<glm::dvec3> color;
      if (!rgb.empty()) {
        color.emplace();
        for (int c = 0; c < 3; ++c)
          (*color)[c] = finite(e, rgb[c]) / (rowOf(e.properties[rgb[c]].number).whole ? 255.0 : 1.0);
      }
      face_.clear();
      for (const double index : list_) {
        if (strips && index == -1) {
          face_.clear();
          continue;
        }
        if (index != std::floor(index) || index < 0 || index >= vertexCount_)
          fail("a vertex index is " + shortest(index) + "; vertices: " + std::to_string(vertexCount_));
        face_.push_back(static_cast<int>(index));
        if (!strips || face_.size() < 3) continue;
        const int c = face_.back(), odd = face_.size() % 2 == 0, a = face_.rbegin()[2 - odd],
                  b = face_.rbegin()[1 + odd];
        if (a != b && b != c && c != a) faces_.add(std::array{a, b, c}, color);
      }
      if (!strips) faces_.add(face_, color);
    });
  }

  /// Reads all elements of a kind. Calls take() after each: values_ then has the numbers, and list_ the list,
  /// of the properties that are used. The others are passed over.
  template <class Take>
  void readRows(const PlyElement& e, const std::vector<int>& used, const Take& take) {
    std::vector<bool> isUsed(e.properties.size(), false);
    for (const int place : used) isUsed[place] = true;
    if (!used.empty())
      for (std::size_t p = 0; p < isUsed.size(); ++p)
        if (!isUsed[p]) leftOut_.add(e.name + '.' + e.properties[p].name);
    values_.assign(e.properties.size(), 0.0);
    spelled_.assign(e.properties.size(), {});
    kind_ = &e;
    for (row_ = 1; row_ <= e.count; ++row_) {
      first_ = text() ? words_.firstOfNextLine() : std::string_view{};
      if (text() && first_.empty()) fail("the file ends before " + which());
      for (std::size_t p = 0; p < isUsed.size(); ++p) readProperty(e.properties[p], p, isUsed[p]);
      if (text()) words_.expectEndOfLine();
      take();
    }
  }

  void readProperty(const PlyProperty& property, std::size_t place, bool used) {
    if (!property.list) {
      values_[place] = number(property.number, used);
      spelled_[place] = word_;
      return;
    }
    const double length = number(property.length, true);
    if (length != std::floor(length) || length < 0) fail("the length of a list is " + shortest(length));
    const int bytes = rowOf(property.number).bytes;
    if (!text() && length * bytes > static_cast<double>(data_.size() - at_)) failShort();
    if (used) list_.clear();
    for (double i = 0; i < length; ++i) {
      const double value = number(property.number, used);
      if (used) list_.push_back(value);
    }
  }

  /// The next number of the element; 0 if it is not used.
  double number(PlyNumber id, bool used) {
    if (text()) {
      word_ = first_.empty() ? words_.next() : std::exchange(first_, {});
      if (word_.empty()) fail("the line of " + which() + " ends early");
      return used ? toNumber(words_, word_, true) : 0.0;
    }
    const std::size_t bytes = rowOf(id).bytes;
    if (bytes > data_.size() - at_) failShort();
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const auto byte = static_cast<unsigned char>(data_[at_ + i]);
      bits |= std::uint64_t{byte} << 8 * (header_.form == PlyForm::LittleEndian ? i : bytes - 1 - i);
    }
    at_ += bytes;
    switch (id) {
      case PlyNumber::Int8:
        return valueOf<std::int8_t>(static_cast<std::uint8_t>(bits));
      case PlyNumber::Uint8:
        return static_cast<double>(bits);
      case PlyNumber::Int16:
        return valueOf<std::int16_t>(static_cast<std::uint16_t>(bits));
      case PlyNumber::Uint16:
        return static_cast<double>(bits);
      case PlyNumber::Int32:
        return valueOf<std::int32_t>(static_cast<std::uint32_t>(bits));
      case PlyNumber::Uint32:
        return static_cast<double>(bits);
      case PlyNumber::Float32:
        return valueOf<float>(static_cast<std::uint32_t>(bits));
      case PlyNumber::Float64:
        return valueOf<double>(bits);
    }
    return 0.0;
  }

  double finite(const PlyElement& e, int place) {
    if (!std::isfinite(values_[place])) fail(e.properties[place].name + " is not finite");
    return values_[place];
  }

  /// `face 12 of 96`
  [[nodiscard]] std::string which() const {
    const std::string quoted = inQuotes(kind_->name);
    return quoted.substr(1, quoted.size() - 2) + ' ' + std::to_string(row_) + " of " +
           std::to_string(kind_->count);
  }
  [[noreturn]] void fail(const std::string& what) const {
    if (text()) words_.fail(what);
    words_.fail(0, which() + ": " + what);
  }
  [[noreturn]] void failShort() const {
    fail("the file ends here, after " + std::to_string(header_.bytes + data_.size()) + " bytes");
  }

  static std::string shortest(double value) {
    const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
    return whole ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(value);
  }

  void expectEnd() {
    if (text()) {
      if (const std::string_view word = words_.firstOfNextLine(); !word.empty())
        words_.fail("unexpected " + inQuotes(word) + " after the last element");
    } else if (data_.find_first_not_of("\r\n", at_) != data_.npos) {
      words_.fail(0, std::to_string(data_.size() - at_) + " bytes follow the last element");
    }
  }

  /// Half a unit of the coordinates.
  [[nodiscard]] double roundingOf(const PlyElement& vertex) const {
    if (text()) return rounding_.rounding();
    double rounding = 0;
    for (const std::string_view axis : {"x", "y", "z"}) {
      const PlyNumber number = vertex.properties[vertex.find(axis)].number;
      int exponent = 0;  // largest_ < 2^exponent
      std::frexp(largest_, &exponent);
      if (rowOf(number).whole) rounding = std::max(rounding, 0.5);
      if (number == PlyNumber::Float32) rounding = std::max(rounding, std::ldexp(1.0, exponent - 25));
    }
    return rounding;
  }

  PlyHeader header_;
  std::string_view data_;
  std::size_t at_ = 0;  ///< of binary data
  Words words_;         ///< of text
  std::string name_;
  std::vector<int> xyz_, uv_, normal_;  ///< the places of properties; empty if there are none
  int vertexCount_ = 0;
  const PlyElement* kind_ = nullptr;
  int row_ = 0;                            ///< number of the element in its kind, from 1
  std::string_view first_, word_;          ///< the line's first word until it is read; the last word read
  std::vector<double> values_, list_;      ///< of the current element
  std::vector<std::string_view> spelled_;  ///< the words of values_, of text
  std::vector<int> face_;
  double largest_ = 0;
  IndexedFaces faces_;
  LeftOut leftOut_;
  RoundingOfNumbers rounding_;
};

}  // namespace

Mesh parsePly(std::string_view text, const std::string& name) { return PlyReader{text, name}.read(); }

Mesh readPly(const std::filesystem::path& file) { return parsePly(readTextFile(file), file.string()); }

}  // namespace xnewell
