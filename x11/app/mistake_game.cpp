#include "x11/app/mistake_game.h"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include "shading/light/equation.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

using Dice = std::mt19937;
/// A place in a list of so many. (The distributions of the standard library differ from machine to machine.)
template <class List>
auto rolled(Dice& dice, List& list) {
  return list.begin() + static_cast<std::ptrdiff_t>(dice() % list.size());
}

/// A mistake, and a small picture that has it.
struct Mistaken {
  const MistakeRow* row;
  IndexImage image;
};

/// True if one of fifty samples differs: that can be seen.
bool areUnlike(const IndexImage& a, const IndexImage& b) {
  std::size_t differing = 0;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) differing += a.pixels[k] != b.pixels[k];
  return 50 * differing > a.pixels.size();
}

std::vector<Mistaken> visibleMistakes(const Scene& scene, PictureSettings settings) {
  settings.width = 120, settings.height = 80;
  PictureCache pictures{scene};
  const auto imageWith = [&](Mistake mistake) {
    settings.light.mistake = mistake;
    return pictures.make(settings, 0).image();
  };
  const IndexImage right = imageWith(Mistake::None);
  std::vector<Mistaken> all;
  for (const MistakeRow& row : kMistakes)
    if (IndexImage image = imageWith(row.id); areUnlike(image, right))
      all.push_back({&row, std::move(image)});
  return all;
}

/// Four mistakes that look different from each other, in any order; the first one that was drawn is the one
/// that is asked for. Fewer if there are no more.
std::vector<const Mistaken*> drawn(const std::vector<Mistaken>& from, const Mistaken& asked, Dice& dice) {
  std::vector<const Mistaken*> chosen{&asked}, rest;
  for (const Mistaken& one : from) rest.push_back(&one);
  while (!rest.empty() && chosen.size() < 4) {
    const auto at = rolled(dice, rest);
    if (std::ranges::all_of(chosen, [&](const Mistaken* c) { return areUnlike(c->image, (*at)->image); }))
      chosen.push_back(*at);
    rest.erase(at);
  }
  std::iter_swap(chosen.begin(), rolled(dice, chosen));
  return chosen;
}

}  // namespace

Lesson mistakeGame(const Scene& scene, PictureSettings settings, unsigned seed) {
  constexpr std::size_t kSteps = 5;
  if (settings.shading != Shading::Gouraud && settings.shading != Shading::Phong)
    settings.shading = Shading::Flat;
  settings.inPixels = false;
  settings.light.mistake = Mistake::None;
  std::vector<Mistaken> left = visibleMistakes(scene, settings);
  const std::vector<Mistaken> all = left;

  Dice dice{seed};
  Lesson game;
  game.name = "which-mistake", game.title = "which mistake is it?", game.number = 0;
  StepFigure figure;
  figure.scene = std::make_shared<const Scene>(scene), figure.sceneName = scene.name;
  figure.stage = View::SideBySide;
  const auto showing = [&](Mistake above, std::string upper, Mistake below, std::string lower) {
    figure.settings = figure.beside = settings;
    figure.settings.light.mistake = above, figure.beside.light.mistake = below;
    figure.upperLine = std::move(upper), figure.lowerLine = std::move(lower);
    return figure;
  };
  while (!left.empty() && game.steps.size() < kSteps) {
    const auto at = rolled(dice, left);
    const Mistaken asked = *at;
    left.erase(at);
    const std::vector<const Mistaken*> choices = drawn(all, asked, dice);
    if (choices.size() < 3) continue;
    LessonStep step;
    step.heading = "A program with a mistake";
    step.caption = {"Two programs drew this, and one of them has a mistake in its equation."};
    step.figure = showing(Mistake::None, "right", asked.row->id, "with a mistake");
    LessonQuestion question;
    question.asks = "Which mistake is it?";
    for (const Mistaken* const choice : choices) {
      const MistakeRow& row = *choice->row;
      const bool holds = row.id == asked.row->id;
      LessonAnswer answer;
      answer.text = row.words, answer.holds = holds, answer.says = row.is;
      if (!holds) answer.says = "Below is " + answer.text + ". " + answer.says;
      answer.shown = holds ? showing(Mistake::None, "right", row.id, answer.text)
                           : showing(asked.row->id, "with the mistake", row.id, answer.text);
      question.answers.push_back(std::move(answer));
    }
    step.question = std::move(question);
    game.steps.push_back(std::move(step));
  }
  if (game.steps.empty()) throw std::invalid_argument{"This picture shows too few mistakes for a game."};
  return game;
}

}  // namespace xnewell
