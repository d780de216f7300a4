#include "x11/stepper/frames.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_picture.h"

namespace xnewell {

namespace {

constexpr int kLeastWidth = 320;     // pixels: about fifty letters
constexpr int kLargeWidth = 1600;    // from this width on letters are doubled
constexpr int kLeastLabelled = 800;  // a fragment with fewer units has no room for a letter
constexpr int kMargin = 6;
constexpr auto kThinOutlines = " Thin outlines: polygons still in the list; marked ones are brighter.";

}  // namespace

Frames::Frames(const Picture& picture, const SortedScene& sorted, bool textbook,
               const std::vector<int>& steps, const CellPlan& plan, int unit)
    : picture_{picture},
      sorted_{sorted},
      explainer_{picture_.scene().mesh, picture_.snapped(), sorted, textbook},
      replay_{picture_.snapped(), sorted},
      plan_{plan},
      palette_{picture.palette(plan_)},
      unit_{unit},
      voice_{picture.settings().width / unit < kLargeWidth ? Voice::Plain : Voice::Title},
      width_{std::max(kLeastWidth, picture.settings().width)},
      soFar_{picture, sorted, plan_[Cell::Well], 0} {
  rows_ = static_cast<int>(wrapped(lastLines()).size());
  for (const int step : steps) rows_ = std::max(rows_, static_cast<int>(wrapped(linesOf(step)).size()));
}

std::vector<Frames::Line> Frames::linesOf(int step) {
  replay_.goTo(step - 1);
  const int splits = replay_.splits();
  replay_.goTo(step);
  const Event& e = *replay_.event();
  std::vector<Line> lines{{"Step " + std::to_string(step) + " of " + std::to_string(replay_.steps()) + ", " +
                           std::to_string(replay_.painted()) + " painted." +
                           (waitingAreOutlined() ? kThinOutlines : "")}};
  lines.push_back({"P: " + explainer_.name(e.P), cell(Cell::P)});
  if (e.Q >= 0) lines.push_back({"Q: " + explainer_.name(e.Q), cell(Cell::Q)});
  lines.push_back({explainer_.sentence(e, splits)});
  return lines;
}

Rect Frames::pictureArea() const {
  return {0, 0, picture_.settings().width / unit_, picture_.settings().height / unit_};
}

bool Frames::waitingAreOutlined() const {
  const int fragments = static_cast<int>(sorted_.fragments.size()) - replay_.painted();
  return fragments > 0 && fragments <= kMostWaiting;
}

std::vector<Frames::Line> Frames::lastLines() const {
  return {{"Done: " + counted(sorted_.list.size(), "polygon") + ", " +
           counted(static_cast<std::size_t>(sorted_.statistics.splits), "cut") + ", " +
           counted(sorted_.fragments.size(), "fragment") + " painted."}};
}

std::vector<Frames::Line> Frames::wrapped(const std::vector<Line>& lines) const {
  const int pitch = kVoices[static_cast<int>(voice_)].pitch, columns = (width_ - 2 * kMargin) / pitch;
  std::vector<Line> all;
  for (const Line& line : lines) {
    const int indent = line.swatch < 0 ? 0 : 3;  // letters
    Line next{"", line.swatch};
    for (const std::string& text : broken(line.text, columns - indent)) {
      next.text = text;
      all.push_back(next);
      next.swatch = line.swatch < 0 ? -1 : cell(Cell::Paper);
    }
  }
  return all;
}

const IndexImage& Frames::at(int step) {
  const std::vector<Line> lines = linesOf(step);
  compose(soFar_.at(replay_.painted()), wrapped(lines));

  const Event& e = *replay_.event();
  if (waitingAreOutlined())
    outlineWaiting(overPicture().pixels(), replay_, plan_,
                   [&](int id) { return outlineOf(explainer_.fragments().region(id)); });
  if (e.Q >= 0) mark(e.Q, Cell::Q, Stipple::Diagonals, "Q");
  if (e.kind == Event::Kind::Split) {
    const int behind = explainer_.fragments().pieceOf(replay_.splits() - 1);
    mark(behind, Cell::P, Stipple::Eighth, "a");
    mark(behind + 1, Cell::P, Stipple::Quarter, "b");
  } else {
    mark(e.P, Cell::P, Stipple::Quarter, "P");
  }
  return frame_;
}

const IndexImage& Frames::finished() {
  compose(soFar_.at(static_cast<int>(sorted_.fragments.size())), wrapped(lastLines()));
  return frame_;
}

/// Puts the picture so far and the strip together.
void Frames::compose(const IndexImage& soFar, const std::vector<Line>& lines) {
  const VoiceRow& voice = kVoices[static_cast<int>(voice_)];
  const int rowHeight = 15 * voice.scale, strip = rows_ * rowHeight + 2 * kMargin;
  frame_ = IndexImage{width_, soFar.height + strip, cell(Cell::Panel)};
  Painter painter{frame_};
  painter.place(soFar, 0, 0);
  painter.fillRect({0, soFar.height, width_, strip}, cell(Cell::Paper));
  painter.hline(0, soFar.height, width_, cell(Cell::Rule));
  int top = soFar.height + kMargin;
  for (const Line& line : lines) {
    int x = kMargin;
    if (line.swatch >= 0) {
      const int side = 11 * voice.scale;
      painter.fillRect({x, top + voice.scale, side, side}, static_cast<std::uint8_t>(line.swatch));
      x += 3 * voice.pitch;
    }
    painter.text(x, top + 11 * voice.scale, line.text, cell(Cell::Ink), voice_);
    top += rowHeight;
  }
}

void outlineWaiting(Painter fine, const Replay& replay, const CellPlan& plan,
                    const std::function<Outline(int)>& placed) {
  for (const auto& [id, marked] : replay.list(kMostWaiting))
    outline(fine, placed(id), plan[marked ? Cell::Faint : Cell::WellLine]);
}

/// Tints a fragment if it is not painted yet, outlines it, and draws its letter in the middle.
void Frames::mark(int fragment, Cell color, Stipple tint, std::string_view letter) {
  const bool paintedNow = replay_.event()->kind == Event::Kind::Paint;
  const auto [samples, x, y] = tintFragment(
      overPicture(), pictureArea(), {picture_.settings().width, picture_.settings().height},
      picture_.snapped(), sorted_, fragment, paintedNow ? std::nullopt : std::optional{tint}, cell(color));

  Painter painter = overPicture(), fine = painter.pixels();
  const int thickness = std::max(1, std::min(pictureArea().width, pictureArea().height) / 250);
  const Outline figure = outlineOf(explainer_.fragments().region(fragment));
  if (thickness > 1) outline(fine, figure, cell(Cell::Black), {thickness + 2});
  outline(fine, figure, cell(color), {thickness});

  const VoiceRow& voice = kVoices[static_cast<int>(voice_)];
  const int scale = voice.scale * unit_;
  if (samples < kLeastLabelled * scale * scale) return;
  const Rect plate{x - 5 * voice.scale, y - 7 * voice.scale, 11 * voice.scale, 15 * voice.scale};
  painter.fillRect(plate, cell(color));
  painter.frame(plate, cell(Cell::Black));
  painter.text(plate.x + 3 * voice.scale, plate.y + 11 * voice.scale, letter, cell(Cell::Black), voice_);
}

}  // namespace xnewell
