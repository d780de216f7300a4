#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Questions for an exam, with numbers of their own and answers that are computed.

struct ExamQuestion {
  std::string kind = {};
  std::string text = {};                ///< one paragraph
  std::vector<std::string> lines = {};  ///< below it: the corners of polygons. Then the picture belongs to it
  /// A number and how far an answer may be off; or choices and the index of the right one; or both.
  double number = 0, tolerance = 0;
  std::vector<std::string> choices = {};
  std::size_t right = 0;
  std::string solution = {};  ///< one paragraph: how the answer is found
};

/// What questions about a scene ask for.
struct QuestionScene {
  explicit QuestionScene(const Scene& scene, const PictureSettings& settings);
  Picture picture;                    ///< unsorted, with planes
  SortedScene sorted;                 ///< the textbook's run, recorded
  std::vector<int> nearest, byMeanZ;  ///< the face at each sample
  std::string name;
  std::string png;  ///< the bytes of the right picture
};

/// `count` questions, the kinds in turn. The same seed gives the same questions on every machine.
[[nodiscard]] std::vector<ExamQuestion> makeQuestions(const QuestionScene& scene, int count, unsigned seed);

/// A file that Moodle imports. Questions about the scene have the picture in them.
[[nodiscard]] std::string questionsAsGift(const std::vector<ExamQuestion>& questions, const std::string& png);
struct QuestionTexts {
  std::string asked, solved;
};
[[nodiscard]] QuestionTexts questionsAsText(const std::vector<ExamQuestion>& questions);

}  // namespace xnewell
