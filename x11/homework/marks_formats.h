#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace xnewell {

/// The files in which marks leave the program.

struct ClassMarks;

enum class MarksFormat { Csv, Html, Gradescope, Classroom50, PrairieLearn, JUnit };
struct MarksFormatRow {
  MarksFormat id;
  std::string_view name;
  std::string (*text)(const ClassMarks& marks);
  bool pictures = false;                        ///< it shows them
  bool ofOne = false;                           ///< it is of one student: all folders are his
  std::span<const char* const> variables = {};  ///< of the environment; it needs them
};
/// CSV: a line a file, or with a rubric a line a student and a column a stage; a field that a spreadsheet
/// could take for a formula begins with an apostrophe. HTML: one file with the pictures in it, which asks for
/// nothing from elsewhere. The results of Gradescope, Classroom 50 and PrairieLearn are of one hand-in.
/// JUnit: a suite a student.
extern const std::array<MarksFormatRow, 6> kMarksFormats;
[[nodiscard]] inline const MarksFormatRow& rowOf(MarksFormat format) {
  return kMarksFormats[static_cast<std::size_t>(format)];
}

}  // namespace xnewell
