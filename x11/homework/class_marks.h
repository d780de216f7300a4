#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/judge_order.h"

namespace xnewell {

/// The homework of a class: the pictures, the painting orders, the runs and the answers in a folder, a row
/// each.

struct MarkedFile {
  std::string file;          ///< its path in the folder; "" for what is missing
  std::string student = {};  ///< whose it is; "" if the folder does not say
  std::string stage = {};    ///< of the rubric; "" without one
  std::string place = {};    ///< HandIn::place
  double points = 0, most = 1;
  std::string verdict = {};  ///< one word: right, allowed, mistake, one-of, numbers, unknown, other-scene,
                             ///< wrong, answers, unreadable, missing
  std::string words = {};    ///< one line
  std::string mistakes = {}, terms = {};  ///< with blanks between them
  std::optional<double> explained = {}, informative = {};
  std::optional<std::pair<int, int>> pixel = {};
  std::optional<int> face = {};
  /// Of a file of answers: how many questions are answered, and how many of them right at the first try.
  int asked = 0, right = 0;
  struct Shown {
    std::string_view label;
    std::string png;  ///< the bytes of a small one
  };
  std::vector<Shown> pictures = {};  ///< of a picture: itself, the right one, and their difference
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
  /// The path is that in the folder. Never throws for what is in the file: it is unreadable then.
  /// @throws std::bad_alloc
  [[nodiscard]] MarkedFile mark(const std::string& folder, const std::string& path);

 private:
  void markPicture(MarkedFile& row, const std::string& path);
  void showPictures(MarkedFile& row, const RgbImage& yours, Diagnoser& diagnoser);
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
  std::map<std::pair<int, int>, RgbImage> right_;                         ///< pictures, by size
  std::map<std::pair<int, int>, Picture> planes_;                         ///< for orders, by size
};

/// What a row earns of `most` points: a right one all, and answers the share that is right at the first try.
[[nodiscard]] double pointsFor(const MarkedFile& row, double most);

struct ClassMarks {
  std::string title;
  std::vector<std::string> stages;  ///< of the rubric; empty without one
  std::vector<MarkedFile> rows;     ///< those of a student one after the other
};
/// The rows of each student. Without a rubric, a file of nobody is by itself.
[[nodiscard]] std::vector<std::span<const MarkedFile>> byStudent(const ClassMarks& marks);

/// How many files have each verdict, and which mistakes the class made, the commonest first.
[[nodiscard]] std::string summaryOf(const ClassMarks& marks);

}  // namespace xnewell
