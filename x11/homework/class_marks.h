#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/judge_order.h"

namespace xnewell {

/// The homework of a class: the pictures, the painting orders, the runs and the answers in a folder, a row
/// each.

struct MarkedFile {
  std::string file;          ///< its name in the folder
  std::string verdict = {};  ///< one word: right, allowed, mistake, one-of, numbers, unknown, other-scene,
                             ///< wrong, answers, unreadable
  std::string words = {};    ///< one line
  std::string mistakes = {}, terms = {};  ///< with blanks between them
  std::optional<double> explained = {}, informative = {};
  std::optional<std::pair<int, int>> pixel = {};
  std::optional<int> face = {};
  /// Of a file of answers: how many questions are answered, and how many of them right at the first try.
  int asked = 0, right = 0;
  std::string picture = {};  ///< the bytes of a small PNG; "" for none
};

/// The answer that holds, from 0, at a step of a lesson; -1 if that step asks nothing. Nothing for a lesson
/// that the program does not have: then the file is believed.
using RightAnswer = std::function<std::optional<int>(const std::string& lesson, int step)>;

/// Marks files against one scene. What files share is made once.
class Marker {
 public:
  /// `size` is that of all pictures, and of the orders that do not say theirs; without it each picture has
  /// its own, and such an order that of the settings.
  Marker(
      Scene scene, PictureSettings settings, std::optional<glm::ivec2> size, bool pictures,
      RightAnswer rightAnswer = [](const std::string&, int) { return std::nullopt; });
  /// Never throws for what is in the file: it is unreadable then. @throws std::bad_alloc
  [[nodiscard]] MarkedFile mark(const std::string& folder, const std::string& name);

 private:
  void markPicture(MarkedFile& row, const std::string& path);
  [[nodiscard]] const Picture& planesAt(glm::ivec2 size);
  /// Of an order, or of a run.
  void markOrder(MarkedFile& row, const std::string& path);
  void markAnswers(MarkedFile& row, const std::string& path) const;

  Scene scene_;
  PictureSettings settings_;
  std::optional<glm::ivec2> size_;
  bool pictures_;
  RightAnswer rightAnswer_;
  std::map<std::pair<int, int>, std::unique_ptr<Diagnoser>> diagnosers_;  ///< by size
  std::map<std::pair<int, int>, Picture> planes_;                         ///< for orders, by size
};

/// The names of the regular files in a folder, sorted; hidden files are left out. @throws std::system_error
[[nodiscard]] std::vector<std::string> handedInFiles(const std::string& folder);

/// One line for the head and one for each file. A field that a spreadsheet could take for a formula begins
/// with an apostrophe.
[[nodiscard]] std::string marksAsCsv(const std::vector<MarkedFile>& rows);
/// How many files have each verdict, and which mistakes the class made, the commonest first.
[[nodiscard]] std::string summaryOf(const std::vector<MarkedFile>& rows);
/// One HTML file with the summary, and with the pictures in it. It asks for nothing from elsewhere.
[[nodiscard]] std::string marksAsHtml(const std::string& title, const std::vector<MarkedFile>& rows);

}  // namespace xnewell
