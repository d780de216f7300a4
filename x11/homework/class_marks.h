#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/judge_order.h"

namespace xnewell {

/// The homework of a class: the pictures and the painting orders in a folder, a row each.

struct MarkedFile {
  std::string file;          ///< its name in the folder
  std::string verdict = {};  ///< one word: right, allowed, mistake, one-of, numbers, unknown, other-scene,
                             ///< wrong, unreadable
  std::string words = {};    ///< one line
  std::string mistakes = {}, terms = {};  ///< with blanks between them
  std::optional<double> explained = {}, informative = {};
  std::optional<std::pair<int, int>> pixel = {};
  std::optional<int> face = {};
  std::string picture = {};  ///< the bytes of a small PNG; "" for none
};

/// Marks files against one scene. What files share is made once.
class Marker {
 public:
  /// `size` is that of all pictures; without it each picture has its own.
  Marker(Scene scene, PictureSettings settings, std::optional<glm::ivec2> size, bool pictures);
  /// Never throws for what is in the file: it is unreadable then. @throws std::bad_alloc
  [[nodiscard]] MarkedFile mark(const std::string& folder, const std::string& name);

 private:
  void markPicture(MarkedFile& row, const std::string& path);
  void markOrder(MarkedFile& row, const std::string& path);

  Scene scene_;
  PictureSettings settings_;
  std::optional<glm::ivec2> size_;
  bool pictures_;
  std::map<std::pair<int, int>, std::unique_ptr<Diagnoser>> diagnosers_;  ///< by size
  std::optional<Picture> picture_;                                        ///< for orders
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
