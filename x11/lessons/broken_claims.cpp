#include "x11/lessons/broken_claims.h"

#include <optional>

#include "shading/picture/picture_cache.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/lessons/lesson_sight.h"

namespace xnewell {

namespace {

/// Adds a sentence for each claim of the exhibit that does not hold where it is drawn.
void check(const Exhibit& exhibit, const std::string& place, const Layout& window,
           std::vector<std::string>& broken) {
  if (exhibit.claims.empty()) return;
  constexpr std::uint8_t kGround = 8;
  const SightLayout at = layoutOfSight(sightOf(window), exhibit, window.compact);
  const auto drawn = [&](PictureSettings settings, const Rect& area) {
    settings.width = area.width, settings.height = area.height;
    return makePicture(*exhibit.scene, settings, kGround);
  };
  const Picture picture = drawn(exhibit.settings, at.picture);
  std::optional<Picture> lower;
  if (exhibit.stage == Stage::SideBySide) lower = drawn(exhibit.beside, at.lower);
  ShownExhibit facts{picture, picture.image(), lower ? &lower->image() : nullptr, exhibit};
  for (const Claim& claim : exhibit.claims) {
    if (facts.holds(claim)) continue;
    const FactRow& fact = allFacts()[static_cast<std::size_t>(claim.fact)];
    broken.push_back(place + ": " + std::string{fact.name} + " is " + facts.text(fact) +
                     ", which is not what the lesson claims");
  }
}

}  // namespace

std::vector<std::string> brokenClaims(const Lesson& lesson, glm::ivec2 window) {
  const Layout at = layoutOf(window.x, window.y);
  std::vector<std::string> broken;
  for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
    const std::string place = "step " + std::to_string(k + 1);
    check(lesson.steps[k].exhibit, place, at, broken);
    if (!lesson.steps[k].question) continue;
    char letter = 'a';
    for (const LessonAnswer& answer : lesson.steps[k].question->answers)
      check(answer.shown, place + ", answer " + letter++, at, broken);
  }
  return broken;
}

}  // namespace xnewell
