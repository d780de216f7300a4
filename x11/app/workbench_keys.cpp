#include <algorithm>
#include <utility>

#include "x11/app/workbench.h"
#include "x11/window/layout.h"
#include "x11/window/picture_view.h"

namespace xnewell {

/// What keys do in all views.

void Workbench::press(const Key& key) {
  notice_.clear();
  told_.clear();
  pointed_.reset();
  if (key.letter != 'q') warned_ = false;
  if (line_.isOpen()) return line_.press(key);
  if (help_ && key.letter != '?') {  // the list of keys closes, so that the user sees what the key does
    help_ = false;
    if (key.name == NamedKey::Escape) return;
  }
  if (turnsPage(key)) return;
  for (int k = 0; k < 2 && waits(key); ++k) update(dragging_);
  if (bench().press(key) || pressIn(generalKeys(), key, *this)) return;
  notify(nameOf(key) + " does nothing here; ? lists all keys.");
}

KeyTable Workbench::keys() {
  KeyTable table = bench().keys();
  if (lecture_) {  // PgUp and PgDn turn its pages; a teacher needs them most
    std::erase_if(table, [](const KeyRow& row) { return std::ranges::any_of(row.keys, turning); });
    KeyTable pages = pageKeys();
    append(pages, std::move(table));
    table = std::move(pages);
  }
  append(table, generalKeys());
  return table;
}

KeyTable Workbench::pageKeys() {
  KeyTable table;
  for (const NamedKey key : {NamedKey::PageUp, NamedKey::PageDown})
    table.push_back({{key},
                     "page",
                     "the lecture's page before, the next; in a lesson its steps come first",
                     [this, key](const Key&) { static_cast<void>(turnsPage(key)); }});
  return table;
}

KeyTable Workbench::generalKeys() {
  KeyTable table;
  const auto add = [&](char letter, const char* legend, const char* does, auto act) {
    table.push_back({{letter}, legend, does, [act](const Key&) { act(); }});
  };
  if (!came_.empty() || visitsFromLesson()) {
    const View to = came_.empty() ? View::Lesson : came_.back().view;
    table.push_back({{NamedKey::Escape},
                     to == View::Lesson ? "the lesson" : "back",
                     to == View::Lesson ? "go back to the lesson" : "go back to the view before",
                     [this](const Key&) { goBack(); }});
  }
  add('u', "undo", "undo, redo", [this] { undo(); });
  add('U', "", "undo, redo", [this] { done(work_.redo(), "redo"); });
  add('r', "reset", "reset the set-up, and what views have changed", [this] {
    bool changed = work_.setup != work_.defaults;
    for (const auto& one : benches_) changed |= one->reset();
    done(changed, "reset");
    change('r', [this](Setup& s) { s = work_.defaults; });
  });
  const char* const files = "save the set-up as a scene file; open a scene, or a picture";
  add('w', "save", files, [this] { askToSave(); });
  add('e', "", files, [this] { askToOpen(); });
  add('C', "", "print and copy the finding, the table and their command", [this] { copyCommand(); });
  add('I', "", "write a picture; from views 1 and 2 also a figure", [this] { writePicture(); });
  const char* const full = "fill the screen, in letters as large as fit, or go back";
  table.push_back({{NamedKey::F11, 'f'}, "", full, [this](const Key&) { fillScreen({}); }});
  if (fillsScreen_)
    table.push_back({{NamedKey::Escape}, "", full, [this](const Key&) { fillScreen(false); }});
  if (bench().hasDrawer())
    add(kDrawerKey, "", "put the controls away, or bring them back", [this] {
      bench().hover(-1, -1);  // what was under the pointer moves away
      if (shut_ || !picture_->showAll()) shut_ = !shut_;
      layOut();
    });
  add('Z', "", "larger letters and controls; after the largest, the smallest", [this] { takeNextScale(); });
  for (const ViewRow& row : kWindowViews)
    add(row.key, "", "the views; or click their names", [this, id = row.id] { visit(id); });
  add('q', "quit", "quit", [this] { quit(); });
  add('?', "all keys", "open this list, close it", [this] { help_ = !help_; });
  return table;
}

void Workbench::quit() {
  if (isSaved() || std::exchange(warned_, true))
    quit_ = true;
  else
    notify("Changes since " + work_.file + " are not saved: press w to save, or q again to quit.");
}

void Workbench::done(bool something, const char* what) {
  if (something) return;
  const bool stored = !shown_ || shown_->colors.effects == PaletteEffects{};
  notify(std::string{"There is nothing to "} + what +
         (stored ? " here." : " here; Esc restores the stored colours."));
}

}  // namespace xnewell
