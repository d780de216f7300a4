#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "x11/drawing/painter.h"

/// What a view or a command has to say, as a value: said once, and told as a page of the window, as text, as
/// JSON, as lines to copy, and as questions.
namespace xnewell::page {

/// What JSON has: with all digits.
struct Data;
using List = std::vector<Data>;
/// A type of its own: if a copy of a variant of strings and vectors alone is refused memory, g++ 12 destroys
/// what it has not made.
struct Object : std::vector<std::pair<std::string_view, Data>> {
  using vector::vector;
};
struct Data : std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, List, Object> {
  using variant::variant;
  Data(int v) : variant{std::int64_t{v}} {}
  Data(std::size_t v) : variant{static_cast<std::int64_t>(v)} {}
  Data(const char* v) : variant{std::string{v}} {}
  Data(std::string_view v) : variant{std::string{v}} {}
  template <glm::length_t n, class T>
  Data(const glm::vec<n, T>& v) : variant{List(&v[0], &v[0] + n)} {}
  template <class T>
  requires(std::same_as<T, int> || std::same_as<T, std::string> || std::same_as<T, std::string_view>)
      Data(const std::vector<T>& v)
      : variant{List(v.begin(), v.end())} {}
  template <class T>
  Data(const std::optional<T>& v) {
    if (v) *this = Data{*v};
  }
};

/// Words may hold these. A value that may be asked has a rank, its place in the chain: while one is asked, it
/// and all of higher rank are question marks. A tab: what follows stands at the right edge.
[[nodiscard]] std::string asked(int rank, std::string_view value);
[[nodiscard]] std::string strong(std::string_view value);
inline constexpr std::string_view kTick = "\4";

enum class Tone { Ink, Bold, Soft, Alarm };

/// A line, and what JSON has for it. `key` empty: not in JSON; `words` empty: only in JSON.
struct Fact {
  std::string_view key = {};
  Data data = {};
  std::string words = {};
  Tone tone = Tone::Ink;
  int weight = 5;  ///< without room, the lightest go first; 0: not in a window
  int indent = 0;  ///< letters
  int tells = 0;   ///< rank: not there while a value up to it is asked
};

struct Column {
  std::string head = {};
  std::string_view key = {};  ///< in JSON
  bool right = false;         ///< aligned
  bool lane = false;          ///< marks on a line, as wide as there is room
  char bracket = 0;           ///< '[' or ']', as high as the table, or '='
  int weight = 9;             ///< without room, the lightest go first
};
struct Entry {
  std::string words = {};
  Data data = {};
  Tone tone = Tone::Ink;
  double share = 0;                   ///< on a lane
  std::optional<double> number = {};  ///< in place of words: without room it has fewer decimals
  int decimals = 4, most = 9;         ///< of it; `most`: characters
  int span = 1;                       ///< columns that it reaches over
  std::optional<int> swatch = {};     ///< a cell that is shown beside the words
};
struct Table {
  std::string_view key = {};
  std::vector<Column> columns = {};
  std::vector<std::vector<Entry>> rows = {};
  std::vector<std::vector<Entry>> foot = {};  ///< not in JSON
  int chosen = -1;
  int least = 3, most = 12;  ///< rows, at least 2; a line stands for the others
  int rowWeight = 4;         ///< of those above the least
  int id = 0;                ///< of what a click finds, with the row
  int weight = 9, indent = 0, tells = 0;
};

/// A white box: what was found, and why. Without room the last lines go.
struct Finding {
  std::string bold = {}, why = {};
  bool alarm = false;
  int weight = 8, indent = 0, tells = 0;
};

/// A drawing, which only a window has: a strip of full width, or beside the lines that follow. It owns what
/// it draws.
struct Sketch {
  std::function<void(Pen&, const Rect&)> draw;
  int lines = 1;        ///< at least
  bool beside = false;  ///< the lines that follow, and as large as there is room
  bool left = false;    ///< of the lines, and a square
  double most = 0.4;    ///< of the page's height
  int id = 0;
  int weight = 5, indent = 0, tells = 0;
};

using Part = std::variant<Fact, Table, Finding, Sketch>;
struct Section {
  std::string title = {}, aside = {};
  std::vector<Part> parts = {};

  template <class P>
  P& add(P part) {
    return std::get<P>(parts.emplace_back(std::move(part)));
  }
  /// A line.
  Fact& say(std::string words, int weight = 5, int tells = 0) {
    return add(Fact{.words = std::move(words), .weight = weight, .tells = tells});
  }
  /// A line, and what JSON has for it; without words it is only in JSON.
  void fact(std::string_view key, Data data, std::string words = {}, int weight = 5, int tells = 0) {
    add(Fact{
        .key = key, .data = std::move(data), .words = std::move(words), .weight = weight, .tells = tells});
  }
};

/// A value that can be asked for. It is right within half of the last digit that is typed; if it picks a
/// cell, that cell is right, too.
struct Question {
  int rank = 0;
  std::string name;
  double value = 0, written = 0;  ///< as the page writes it, where terms are rounded to add up
  int decimals = 4;
  std::function<int(double)> lands = {};  ///< the cell that such a value picks
  struct Judged {
    bool isRight = false;
    std::string complaint = {};     ///< if the text is no number, or has too few digits
    std::optional<int> lands = {};  ///< the cell of the answer
  };
  [[nodiscard]] Judged judged(const std::string& text) const;
};

struct Page {
  std::string of = {};                  ///< the first line of a text: what the page is about
  std::string title = {};               ///< one large word
  std::vector<std::string> under = {};  ///< two lines beside it
  bool alarms = false;                  ///< the title does
  std::vector<Section> sections = {};
  std::vector<Question> questions = {};
  std::string_view order = {};  ///< of JSON's keys, between spaces; others follow
  int indent = -1;              ///< of JSON, in letters; -1: one line
};

/// Values of this rank and of higher ones are hidden; 0: none is.
struct Hiding {
  int from = 0;
  [[nodiscard]] bool hides(int rank) const { return from > 0 && rank >= from; }
};

[[nodiscard]] std::vector<std::string> asLines(const Page& page, Hiding hiding = {});
[[nodiscard]] std::string asText(const Page& page);
[[nodiscard]] std::string asJson(const Page& page);
[[nodiscard]] std::string asJson(const Data& data);

/// What a click finds.
struct Pressed {
  Rect area;
  int id = 0, row = 0;
};
/// Units from line to line. It depends on the window alone, so lines keep still from page to page.
[[nodiscard]] int pitchOf(const Rect& body);
/// `leftOut`, if it is not null, gets the words of the parts that had no room.
std::vector<Pressed> draw(Pen& pen, const Page& page, const Rect& area, int pitch, Hiding hiding = {},
                          std::vector<std::string>* leftOut = nullptr);

}  // namespace xnewell::page
