#include "geometry/files/ply_header.h"

#include <algorithm>
#include <charconv>
#include <optional>

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

}  // namespace xnewell
