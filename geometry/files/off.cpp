#include "geometry/files/off.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include "geometry/files/indexed_faces.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name) : words_{text, name}, name_{name} {}

  Mesh read() {
    readHeader();
    for (int i = 1; i <= pointCount_; ++i) readPoint(i);
    for (int i = 1; i <= faceCount_; ++i) readFace(i);
    if (const std::string_view word = words_.firstOfNextLine(); !word.empty())
      words_.fail("unexpected " + inQuotes(word) + " after the last face");
    Mesh mesh = faces_.take(name_, rounding_.rounding());
    for (const std::string& what : {leftOut_.sentence(), rounding_.doubtful()})
      if (!what.empty()) mesh.notes.emplace_back(ParseError{name_, 0, what}.what());
    return mesh;
  }

 private:
  /// `STCNOFF`, and the counts on its line or the next one.
  void readHeader() {
    const std::string_view first = words_.firstOfNextLine();
    if (first.empty()) words_.fail(0, "holds no face");
    std::string_view kind = first;
    const auto takes = [&](std::string_view letters) {
      const bool there = kind.starts_with(letters);
      if (there) kind.remove_prefix(letters.size());
      return there;
    };
    texture_ = takes("ST"), color_ = takes("C"), normal_ = takes("N");
    if (takes("4") || takes("n"))
      words_.fail(inQuotes(first) + ": the points have other than three coordinates");
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (!takes("OFF") || !std::ranges::all_of(kind, isDigit))
      words_.fail("the file begins with " + inQuotes(first) + ", not with OFF");
    kind_ = first.substr(0, first.size() - kind.size());
    std::string_view word = kind.empty() ? words_.next() : kind;
    if (word == "BINARY") words_.fail("the file is a binary OFF file, and only text is read");
    if (word.empty()) word = words_.firstOfNextLine();
    pointCount_ = count(word, "points");
    faceCount_ = count(words_.next(), "faces");
    if (const std::string_view edges = words_.next(); !edges.empty()) (void)count(edges, "edges");
    words_.expectEndOfLine();
    if (color_) leftOut_.add("colours of points");
  }

  int count(std::string_view word, const std::string& of) const {
    if (word.empty()) words_.fail("the number of " + of + " is missing");
    const std::optional<int> number = wholeNumber(word);
    if (!number || *number < 0) words_.fail("malformed number of " + of + " " + inQuotes(word));
    return *number;
  }

  /// No value if the word is not a whole number that fits an int.
  static std::optional<int> wholeNumber(std::string_view word) {
    int value = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return stop == end && error == std::errc{} ? std::optional{value} : std::nullopt;
  }

  [[noreturn]] void failEnds(const char* what, int number, int of) const {
    words_.fail("the file ends before " + std::string{what} + ' ' + std::to_string(number) + " of " +
                std::to_string(of));
  }

  void readPoint(int number) {
    std::string_view word = words_.firstOfNextLine();
    if (word.empty()) failEnds("point", number, pointCount_);
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) word = words_.next();
      if (word.empty()) words_.fail("a point needs three coordinates");
      point[axis] = toNumber(words_, word);
      rounding_.add(word, point[axis]);
    }
    faces_.mesh.points.push_back(point);

    std::array<double, 9> more;  // a normal, a colour and texture coordinates
    std::size_t read = 0;
    for (word = words_.next(); !word.empty() && read < more.size(); word = words_.next())
      more[read] = toNumber(words_, word, normal_ && read < 3), ++read;
    const std::size_t others = (normal_ ? 3 : 0) + (texture_ ? 2 : 0), color = read - others;
    const bool fits = color_ ? read > others && color != 2 && color <= 4 : read == others;
    for (; !word.empty(); word = words_.next()) ++read;
    if (!fits || read > more.size())
      words_.fail("a point of " + kind_ + " does not have " + std::to_string(3 + read) + " numbers");
    if (normal_) faces_.normals.emplace_back(more[0], more[1], more[2]);
    if (texture_) faces_.mesh.uv.emplace_back(more[read - 2], more[read - 1]);
  }

  void readFace(int number) {
    std::string_view word = words_.firstOfNextLine();
    if (word.empty()) failEnds("face", number, faceCount_);
    const std::optional<int> corners = wholeNumber(word);
    if (!corners || *corners < 0) words_.fail("malformed number of corners " + inQuotes(word));
    face_.clear();
    for (int i = 0; i < *corners; ++i) {
      word = words_.next();
      if (word.empty())
        words_.fail("the face has " + std::to_string(i) + " of " + std::to_string(*corners) + " corners");
      const std::optional<int> index = wholeNumber(word);
      if (!index) words_.fail("malformed index " + inQuotes(word));
      if (*index < 0 || *index >= pointCount_)
        words_.fail("index " + std::to_string(*index) +
                    " is out of range; points: " + std::to_string(pointCount_));
      face_.push_back(*index);
    }
    faces_.add(face_, readColor());
  }

  std::optional<glm::dvec3> readColor() {
    std::array<double, 4> value{};
    std::size_t read = 0;
    bool point = false;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (read == value.size()) words_.fail("unexpected " + inQuotes(word));
      value[read++] = toNumber(words_, word);
      point = point || word.find('.') != std::string_view::npos;
    }
    if (read == 0) return std::nullopt;
    if (read == 2) words_.fail("a colour has 1, 3 or 4 numbers; this one has 2");
    if (read == 1) leftOut_.add("indices into a colormap");
    if (read == 1) return std::nullopt;
    if (read == 4) leftOut_.add("opacities");
    return glm::dvec3{value[0], value[1], value[2]} / (point ? 1.0 : 255.0);
  }

  Words words_;
  std::string name_, kind_;  ///< kind_: "COFF"
  bool texture_ = false, color_ = false, normal_ = false;
  int pointCount_ = 0, faceCount_ = 0;
  std::vector<int> face_;  ///< of the current face; a member to reuse its memory
  IndexedFaces faces_;
  LeftOut leftOut_;
  RoundingOfNumbers rounding_;
};

}  // namespace

Mesh parseOff(std::string_view text, const std::string& name) { return OffReader{text, name}.read(); }

Mesh readOff(const std::filesystem::path& file) { return parseOff(readTextFile(file), file.string()); }

}  // namespace xnewell
