#include "shading/frames.h"

#include <algorithm>
#include <cmath>

#include "shading/fill.h"
#include "shading/fragment_spans.h"
#include "shading/painter.h"
#include "shading/wording.h"

namespace {

constexpr int kLeastWidth = 320;     // pixels: some fifty letters
constexpr int kLargeWidth = 1600;    // from here on letters are doubled
constexpr int kMostWaiting = 1000;   // more thin outlines than this are a blot
constexpr int kLeastLabelled = 800;  // a fragment of fewer pixels has no room for a letter
constexpr int kMargin = 6;
constexpr auto kThinOutlines = " Thin outlines: still in the list, marked ones brighter.";

/// The region's sides as lines from pixel to pixel.
void outline(Painter& painter, const Region& region, int thickness, std::uint8_t cell) {
  const auto pixel = [](double v) { return static_cast<int>(std::floor(v / kGrid)); };
  Corner from = region.back().corner;
  for (const Side& side : region) {
    const Corner& to = side.corner;
    painter.line(pixel(from.x), pixel(from.y), pixel(to.x), pixel(to.y), cell, {thickness});
    from = to;
  }
}

}  // namespace

Frames::Frames(const Picture& picture, const SortedScene& sorted, bool textbook,
               const std::vector<int>& steps)
    : picture_{picture},
      sorted_{sorted},
      painter_{picture.painter(sorted)},
      explainer_{picture.scene().mesh, picture.snapped(), sorted, textbook},
      replay_{picture.snapped(), sorted},
      plan_{picture.settings().table.kind},
      palette_{picture.palette(plan_)},
      voice_{picture.settings().width < kLargeWidth ? Voice::Plain : Voice::Title},
      width_{std::max(kLeastWidth, picture.settings().width)},
      soFar_{picture.settings().width, picture.settings().height, plan_[Cell::Well]} {
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
  paintTo(replay_.painted());
  compose(wrapped(lines));

  const Event& e = *replay_.event();
  outlineWaiting();
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
  paintTo(static_cast<int>(sorted_.fragments.size()));
  compose(wrapped(lastLines()));
  return frame_;
}

void Frames::paintTo(int painted) {
  if (painted < painted_) {
    std::ranges::fill(soFar_.pixels, cell(Cell::Well));
    painted_ = 0;
  }
  for (; painted_ < painted; ++painted_) painter_.paint(soFar_, sorted_.fragments[painted_]);
}

/// The picture as it is so far, and the strip.
void Frames::compose(const std::vector<Line>& lines) {
  const VoiceRow& voice = kVoices[static_cast<int>(voice_)];
  const int rowHeight = 15 * voice.scale, strip = rows_ * rowHeight + 2 * kMargin;
  frame_ = IndexImage{width_, soFar_.height + strip, cell(Cell::Panel)};
  for (int j = 0; j < soFar_.height; ++j) std::copy_n(soFar_.row(j), soFar_.width, frame_.row(j));

  Painter painter{frame_};
  painter.fillRect({0, soFar_.height, width_, strip}, cell(Cell::Paper));
  painter.hline(0, soFar_.height, width_, cell(Cell::Rule));
  int top = soFar_.height + kMargin;
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

/// What is not painted yet, in thin lines.
void Frames::outlineWaiting() {
  if (!waitingAreOutlined()) return;
  Painter painter = Painter{frame_}.within({0, 0, soFar_.width, soFar_.height});
  for (const auto& [id, marked] : replay_.list(kMostWaiting))
    outline(painter, explainer_.fragments().region(id), 1, cell(marked ? Cell::Faint : Cell::WellLine));
}

/// A fragment tinted where it is not painted yet, outlined, and with its letter in the middle.
void Frames::mark(int fragment, Cell color, Stipple tint, std::string_view letter) {
  const int W = soFar_.width, H = soFar_.height, faces = static_cast<int>(picture_.snapped().faces.size());
  const Fragment which{explainer_.fragments().faceIndex(fragment), fragment < faces ? -1 : fragment - faces};
  std::int64_t x = 0, y = 0, samples = 0;
  const bool paintedNow = replay_.event()->kind == Event::Kind::Paint;
  forEachSpan(picture_.snapped(), sorted_, which, W, H, [&](int row, int from, int to) {
    samples += to - from, y += std::int64_t{row} * (to - from),
        x += std::int64_t{from + to} * (to - from) / 2;
    for (int i = from; i < to && !paintedNow; ++i)
      if (stippled(tint, i, row)) frame_.row(row)[i] = cell(color);
  });

  Painter painter = Painter{frame_}.within({0, 0, W, H});
  const int thickness = std::max(1, std::min(W, H) / 250);
  const Region region = explainer_.fragments().region(fragment);
  if (thickness > 1) outline(painter, region, thickness + 2, cell(Cell::Black));
  outline(painter, region, thickness, cell(color));

  const VoiceRow& voice = kVoices[static_cast<int>(voice_)];
  if (samples < kLeastLabelled * voice.scale * voice.scale) return;
  const Rect plate{static_cast<int>(x / samples) - 5 * voice.scale,
                   static_cast<int>(y / samples) - 7 * voice.scale, 11 * voice.scale, 15 * voice.scale};
  painter.fillRect(plate, cell(color));
  painter.frame(plate, cell(Cell::Black));
  painter.text(plate.x + 3 * voice.scale, plate.y + 11 * voice.scale, letter, cell(Cell::Black), voice_);
}
