// Writes what your depth sort does, a line for each step. `xnewell judge SCENE --run FILE` finds the first
// false one. C++11; it needs nothing else.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace xnewell_run {

/// A polygon or a piece of one. For a face of the scene `number` is its number there, from 0; to each piece
/// give a number that no polygon has. The camera is the scene's, or that of judge's options; in the picture,
/// which has the size that Run takes, x goes right and y down from the upper left corner of pixel 0,0.
struct Polygon {
  int number;
  std::vector<double> outline;  ///< on the screen, in pixels: x, y, x, y, ...; it may be empty
  /// What flat shading has: normal x, y, z, N.L, cell; it may be empty. A cut copies these to both pieces.
  std::vector<double> shade;
};

class Run {
 public:
  Run(const char* file, int width, int height) : file_(std::fopen(file, "w")) {
    if (file_) std::fprintf(file_, "{\"event\":\"run\",\"size\":[%d,%d]}\n", width, height);
  }
  ~Run() {
    if (file_) std::fclose(file_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  bool isOpen() const { return file_ != nullptr; }

  /// P is the polygon to paint next, if the tests allow it.
  void take(int P) { line("take", P); }
  /// A test of P against Q: "1" to "5", "3'", "4'"; or "6": where they overlap, is P nowhere nearer?
  void test(int P, int Q, const std::string& number, bool answer) {
    line("test", P, Q, ",\"test\":\"" + number + "\",\"outcome\":\"" + (answer ? "yes" : "no") + '"');
  }
  /// Q goes before P: it becomes P.
  void move(int P, int Q) { line("move", P, Q); }
  void mark(int P) { line("mark", P); }
  /// P is split by the plane of Q, into a piece behind it and one in front of it.
  void split(const Polygon& P, int Q, const Polygon& behind, const Polygon& front) {
    line("cut", P.number, Q, more("P", P) + more("behind", behind) + more("in_front", front));
  }
  /// P is painted with this cell of the colour table; -1 if it has many.
  void paint(int P, int cell) { line("paint", P, -1, cell < 0 ? "" : ",\"cell\":" + std::to_string(cell)); }
  void note(const std::string& text) {
    std::string quoted;
    for (const char c : text) quoted += c == '"' || c == '\\' ? '\'' : c >= 0 && c < ' ' ? ' ' : c;
    if (file_) std::fprintf(file_, "{\"event\":\"note\",\"text\":\"%s\"}\n", quoted.c_str());
  }

 private:
  void line(const char* event, int P, int Q = -1, const std::string& rest = "") {
    const std::string other = Q < 0 ? "" : ",\"Q\":" + std::to_string(Q);
    if (!file_) return;
    std::fprintf(file_, "{\"event\":\"%s\",\"P\":%d%s%s}\n", event, P, other.c_str(), rest.c_str());
    std::fflush(file_);  // what was written stays if the program does not end
  }
  static std::string more(const std::string& key, const Polygon& polygon) {
    std::string text = key == "P" ? "" : ",\"" + key + "\":" + std::to_string(polygon.number);
    if (!polygon.outline.empty()) text += ",\"" + key + "_outline\":" + list(polygon.outline, true);
    if (!polygon.shade.empty()) text += ",\"" + key + "_shade\":" + list(polygon.shade, false);
    return text;
  }
  static std::string list(const std::vector<double>& v, bool places) {
    std::string text;
    for (std::size_t k = 0; k < v.size(); ++k) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.17g", v[k]);
      text += (k ? "," : "[") + std::string(places && k % 2 == 0 ? "[" : "") + digits +
              (places && k % 2 ? "]" : "");
    }
    return text + ']';
  }
  std::FILE* file_;
};
}  // namespace xnewell_run
