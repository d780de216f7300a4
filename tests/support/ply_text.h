#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "geometry/files/ply.h"

namespace xnewell {

/// A PLY file, written in any of its forms. It shares no code with the reader.
struct PlyText {
  std::string declared;  ///< the elements and their properties
  struct Value {
    char type;  ///< b, B, s, S, i, I: whole numbers of 1, 2 and 4 bytes, with and without a sign; f, d
    double value;
  };
  std::vector<Value> values;
  std::vector<int> perLine;  ///< of the text: how many values each line has

  [[nodiscard]] std::string as(PlyForm form, const std::string& lineEnd = "\n") const {
    const char* const name = form == PlyForm::Text           ? "ascii"
                             : form == PlyForm::LittleEndian ? "binary_little_endian"
                                                             : "binary_big_endian";
    std::string out, head = "ply\nformat " + std::string{name} + " 1.0\n" + declared + "end_header\n";
    for (const char c : head) out += c == '\n' ? lineEnd : std::string{c};
    std::size_t line = 0;
    int onLine = 0;
    for (const Value& v : values) {
      if (form == PlyForm::Text) {
        char word[40];
        std::snprintf(word, sizeof word, "%.9g", v.value);
        const bool last = ++onLine == (line < perLine.size() ? perLine[line] : -1);
        out += std::string{word} + (last ? lineEnd : " ");
        if (last) ++line, onLine = 0;
        continue;
      }
      std::string bytes(v.type == 'd'                    ? 8
                        : v.type == 'b' || v.type == 'B' ? 1
                        : v.type == 's' || v.type == 'S' ? 2
                                                         : 4,
                        '\0');
      const std::uint64_t bits = v.type == 'd' ? std::bit_cast<std::uint64_t>(v.value)
                                 : v.type == 'f'
                                     ? std::bit_cast<std::uint32_t>(static_cast<float>(v.value))
                                     : static_cast<std::uint64_t>(static_cast<std::int64_t>(v.value));
      for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(bits >> 8 * i);
      if (form == PlyForm::BigEndian) std::ranges::reverse(bytes);
      out += bytes;
    }
    return out;
  }
};

}  // namespace xnewell
