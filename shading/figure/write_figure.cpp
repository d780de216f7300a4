#include "shading/figure/write_figure.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/color/font.h"

namespace xnewell {

namespace {

using Color = FigureColor;

/// A text that grows by numbers and words.
class Text {
 public:
  Text& operator<<(std::string_view words) { return bytes_ += words, *this; }
  Text& operator<<(std::int64_t number) {
    std::array<char, 24> digits;
    bytes_.append(digits.data(), std::to_chars(digits.begin(), digits.end(), number).ptr);
    return *this;
  }
  /// A number after another: a minus sign parts them, or a blank.
  Text& then(int number) {
    if (number >= 0) bytes_ += ' ';
    return *this << number;
  }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// A step of a figure in pixels, exactly.
constexpr std::string_view kStep = ".00390625";
static_assert(kFigureSteps == 256);

constexpr std::int64_t kDash = 3 * kFigureSteps;  ///< the length of a dash, and of a gap

/// "#08f" or "#0088fe".
std::string hex(const Color& color) {
  const std::string text = hexOf(color);
  const bool shorter = std::ranges::all_of(color, [](std::uint8_t c) { return c >> 4 == (c & 15); });
  return shorter ? std::string{'#', text[1], text[3], text[5]} : text;
}

std::string escaped(std::string_view text) {
  std::string xml;
  for (const char c : visible(text))  // XML has no control characters
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else
      xml += c;
  return xml;
}

/// A text as an area: each pixel of its doubled glyphs is a rectangle, and those beside each other are one.
FigurePath lettersOf(const FigureText& text) {
  FigurePath letters{text.color, {}};
  const auto steps = [&](int halves) {
    return static_cast<int>(std::lround(halves * text.size / (2.0 * kGlyphHeight)));
  };
  int left = 0;
  for (const char32_t code : codesOf(text.text)) {
    const DoubledGlyph rows = scale2x(*glyphOf(code));
    for (int j = 0; j < 2 * kGlyphHeight; ++j)
      for (int i = 0, end = 0; i < 2 * kGlyphWidth; i = end + 1) {
        const auto inked = [&](int at) {
          return at < 2 * kGlyphWidth && (rows[j] >> (2 * kGlyphWidth - 1 - at) & 1);
        };
        for (end = i; inked(end);) ++end;
        if (end == i) continue;
        const int top = j - 2 * kGlyphAscent;
        const glm::ivec2 a = text.at + glm::ivec2{steps(left + i), steps(top)},
                         b = text.at + glm::ivec2{steps(left + end), steps(top + 1)};
        letters.loops.push_back({a, {b.x, a.y}, b, {a.x, b.y}});
      }
    left += 2 * kGlyphWidth;
  }
  return letters;
}

/// "1 .502 0 rg ": three decimals tell all of 256 levels apart.
void addColor(Text& text, const Color& color, std::string_view sets) {
  for (const std::uint8_t c : color) {
    const int thousandths = (c * 2000 + 255) / 510;
    if (thousandths == 0 || thousandths == 1000) {
      text << (thousandths == 0 ? "0 " : "1 ");
      continue;
    }
    std::string digits = std::to_string(1000 + thousandths).substr(1);
    while (digits.back() == '0') digits.pop_back();
    text << "." << digits << " ";
  }
  text << sets << "\n";
}

/// The strokes in PDF's operators, which the EPS file defines, too. `colors` sets the colour of a stroke, and
/// `lineTo` draws to a place.
void addStrokes(Text& text, const VectorFigure& figure, std::string_view colors, std::string_view lineTo) {
  for (const FigureStroke& stroke : figure.strokes) {
    addColor(text, stroke.color, colors);
    text << stroke.width << " w " << (stroke.dashed ? 0 : 1) << " J [";
    if (stroke.dashed) text << kDash;
    text << "] 0 d\n";
    for (const FigureLoop& line : stroke.lines)
      for (std::size_t k = 0; k < line.size(); ++k)
        text << line[k].x << " " << line[k].y << " " << (k == 0 ? "m" : lineTo) << "\n";
    text << "S\n";
  }
}

/// The page in the colour of the paper.
void addPaper(Text& text, const VectorFigure& figure, std::string_view setsColor, std::string_view fills) {
  if (figure.paper.empty()) return;
  addColor(text, figure.paper.front(), setsColor);
  text << "0 0 " << figure.width << " " << figure.height << " " << fills << "\n";
}

/// The triangles of a path as a shading of PDF's type 4: a free-form triangle mesh. Its coordinates are whole
/// numbers of 24 bits, so the steps of a figure stay exact.
void addTriangles(Text& pdf, const std::vector<FigureTriangle>& triangles) {
  constexpr int kHalf = 1 << 23;  // coordinates may be negative
  std::string bytes;
  for (const FigureTriangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      bytes += '\0';  // flag: a new triangle
      for (const int at : {t.corners[k].x, t.corners[k].y})
        for (const int shift : {16, 8, 0}) bytes += static_cast<char>((at + kHalf) >> shift & 255);
      for (const std::uint8_t c : t.colors[k]) bytes += static_cast<char>(c);
    }
  pdf << "<</ShadingType 4/ColorSpace/DeviceRGB/BitsPerCoordinate 24/BitsPerComponent 8/BitsPerFlag "
         "8/Decode[";
  for (int axis = 0; axis < 2; ++axis) pdf << -kHalf << " " << kHalf - 1 << " ";
  pdf << "0 1 0 1 0 1]/Length " << static_cast<std::int64_t>(bytes.size()) << ">>\nstream\n"
      << bytes << "\nendstream";
}

}  // namespace

std::string svgOf(const VectorFigure& figure) {
  Text svg;
  svg << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""
      << figure.width << "\" height=\"" << figure.height << "\" viewBox=\"0 0 " << figure.width << " "
      << figure.height << "\">\n";
  if (!figure.note.empty()) svg << "<desc>" << escaped(figure.note) << "</desc>\n";
  if (!figure.paper.empty())
    svg << "<rect width=\"100%\" height=\"100%\" fill=\"" << hex(figure.paper.front()) << "\"/>\n";
  svg << "<g transform=\"scale(" << kStep << ")\">\n";
  for (const FigurePath& path : figure.paths) {
    svg << "<path fill=\"" << hex(path.color) << "\" d=\"";
    for (const FigureLoop& loop : path.loops) {
      svg << "M" << loop[0].x;
      svg.then(loop[0].y) << "l";
      for (std::size_t k = 1; k < loop.size(); ++k) {
        const glm::ivec2 on = loop[k] - loop[k - 1];
        (k == 1 ? svg << on.x : svg.then(on.x)).then(on.y);
      }
      svg << "z";
    }
    svg << "\"/>\n";
  }
  for (const FigureStroke& stroke : figure.strokes) {
    svg << "<path fill=\"none\" stroke=\"" << hex(stroke.color) << "\" stroke-width=\"" << stroke.width
        << "\" stroke-linecap=\"" << (stroke.dashed ? "butt" : "round") << "\"";
    if (stroke.dashed) svg << " stroke-dasharray=\"" << kDash << "\"";
    svg << " d=\"";
    for (const FigureLoop& line : stroke.lines) {
      svg << "M" << line[0].x;
      svg.then(line[0].y);
      for (std::size_t k = 1; k < line.size(); ++k) svg << "L" << line[k].x, svg.then(line[k].y);
    }
    svg << "\"/>\n";
  }
  for (const FigureText& text : figure.texts)
    svg << "<text x=\"" << text.at.x << "\" y=\"" << text.at.y << "\" fill=\"" << hex(text.color)
        << "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" << text.size << "\">"
        << escaped(text.text) << "</text>\n";
  svg << "</g>\n</svg>\n";
  return svg.take();
}

std::string pdfOf(const VectorFigure& figure) {
  Text drawing;
  drawing << "0 0 " << figure.width << " " << figure.height << " re W n\n";
  addPaper(drawing, figure, "rg", "re f");
  drawing << kStep << " 0 0 -" << kStep << " 0 " << figure.height << " cm\n";
  std::optional<Color> last;
  std::vector<const FigurePath*> shadings;
  const auto fill = [&](const FigurePath& path) {
    if (!path.triangles.empty()) {
      drawing << "/S" << std::ssize(shadings) << " sh\n";
      shadings.push_back(&path);
      return;
    }
    if (last != path.color) addColor(drawing, path.color, "rg");
    last = path.color;
    for (const FigureLoop& loop : path.loops) {
      for (std::size_t k = 0; k < loop.size(); ++k)
        drawing << loop[k].x << " " << loop[k].y << (k == 0 ? " m\n" : " l\n");
      drawing << "h\n";
    }
    drawing << "f\n";
  };
  std::ranges::for_each(figure.paths, fill);
  addStrokes(drawing, figure, "RG", "l");
  for (const FigureText& text : figure.texts) fill(lettersOf(text));
  const std::string contents = drawing.take();

  // The bytes above 127 tell programs that the file is not plain text.
  Text pdf;
  pdf << "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  if (!figure.note.empty()) pdf << "%xnewell: " << figure.note << "\n";
  std::vector<std::size_t> places;
  const auto begin = [&]() -> Text& {
    places.push_back(pdf.size());
    return pdf << static_cast<std::int64_t>(places.size()) << " 0 obj\n";
  };
  begin() << "<</Type/Catalog/Pages 2 0 R>>\nendobj\n";
  begin() << "<</Type/Pages/Kids[3 0 R]/Count 1>>\nendobj\n";
  begin() << "<</Type/Page/Parent 2 0 R/MediaBox[0 0 " << figure.width << " " << figure.height
          << "]/Resources<<";
  if (!shadings.empty()) {
    pdf << "/Shading<<";
    for (std::int64_t k = 0; k < std::ssize(shadings); ++k) pdf << "/S" << k << " " << k + 5 << " 0 R";
    pdf << ">>";
  }
  pdf << ">>/Contents 4 0 R>>\nendobj\n";
  begin() << "<</Length " << static_cast<std::int64_t>(contents.size()) << ">>\nstream\n"
          << contents << "endstream\nendobj\n";
  for (const FigurePath* path : shadings) {
    addTriangles(begin(), path->triangles);
    pdf << "\nendobj\n";
  }
  const std::size_t table = pdf.size();
  pdf << "xref\n0 " << static_cast<std::int64_t>(places.size() + 1) << "\n0000000000 65535 f \n";
  for (const std::size_t place : places)
    pdf << std::to_string(10'000'000'000 + place).substr(1) << " 00000 n \n";
  pdf << "trailer\n<</Size " << static_cast<std::int64_t>(places.size() + 1) << "/Root 1 0 R>>\nstartxref\n"
      << static_cast<std::int64_t>(table) << "\n%%EOF\n";
  return pdf.take();
}

std::string epsOf(const VectorFigure& figure) {
  Text eps;
  eps << "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 " << figure.width << " " << figure.height
      << "\n%%LanguageLevel: 2\n%%EndComments\n";
  if (!figure.note.empty()) eps << "%xnewell: " << figure.note << "\n";
  eps << "10 dict begin gsave\n/c{setrgbcolor}bind def/m{moveto}bind def/l{rlineto}bind def"
         "/h{closepath}bind def/f{fill}bind def"
         "/L{lineto}bind def/w{setlinewidth}bind def/J{setlinecap}bind def/d{setdash}bind def/S{stroke}bind "
         "def\n"
      << "0 0 " << figure.width << " " << figure.height << " rectclip\n";
  addPaper(eps, figure, "c", "rectfill");
  eps << "0 " << figure.height << " translate " << kStep << " -" << kStep << " scale\n";
  std::optional<Color> last;
  const auto fill = [&](const FigurePath& path) {
    if (last != path.color) addColor(eps, path.color, "c");
    last = path.color;
    for (const FigureLoop& loop : path.loops) {
      eps << loop[0].x << " " << loop[0].y << " m\n";
      for (std::size_t k = 1; k < loop.size(); ++k)
        eps << loop[k].x - loop[k - 1].x << " " << loop[k].y - loop[k - 1].y << " l\n";
      eps << "h\n";
    }
    eps << "f\n";
  };
  std::ranges::for_each(figure.paths, fill);
  addStrokes(eps, figure, "c", "L");
  last.reset();  // a stroke has set another colour
  for (const FigureText& text : figure.texts) fill(lettersOf(text));
  eps << "grestore end\n%%EOF\n";
  return eps.take();
}

const FigureFormat* figureFormatOf(std::string_view file) {
  std::string name{file};
  std::ranges::transform(name, name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  const auto found = std::ranges::find_if(
      kFigureFormats, [&](const FigureFormat& format) { return name.ends_with(format.ending); });
  return found == kFigureFormats.end() ? nullptr : &*found;
}

std::optional<std::string> noteInFigure(const std::string& file) {
  constexpr std::size_t kBeginning = 16'000;  // a note of 2,000 bytes has at most five for each
  const std::string text = readTextFile(file).substr(0, kBeginning);
  const auto between = [&](std::string_view begin, std::string_view end) -> std::optional<std::string> {
    const std::size_t at = text.find(begin), until = text.find(end, at == text.npos ? at : at + begin.size());
    if (at == text.npos || until == text.npos) return {};
    return text.substr(at + begin.size(), until - at - begin.size());
  };
  if (!text.starts_with("<?xml")) return between("\n%xnewell: ", "\n");
  std::optional<std::string> note = between("<desc>", "</desc>");
  if (!note) return note;
  for (const auto& [xml, is] : {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&amp;", "&"}})
    for (std::size_t at = 0; (at = note->find(xml, at)) != note->npos; ++at)
      note->replace(at, std::string_view{xml}.size(), is);
  return note;
}

}  // namespace xnewell
