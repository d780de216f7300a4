#include "x11/app/lecture.h"

#include "x11/app/workbench.h"
#include "x11/lessons/lesson_view.h"
#include "x11/stepper/sort_view.h"

namespace xnewell {

std::string Lecture::title() const {
  return std::to_string(at_ + 1) + " of " + std::to_string(pages_.size()) + ": " + now().title;
}

bool Lecture::turn(int pages) {
  const auto to = static_cast<std::ptrdiff_t>(at_) + pages;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(pages_.size())) return false;
  at_ = static_cast<std::size_t>(to);
  wait();
  return true;
}

void Lecture::turnByItself() {
  at_ = (at_ + 1) % pages_.size();
  wait();
}

/// The lecture in the window.

void Workbench::lecture(Lecture lecture) {
  lecture_ = std::move(lecture);
  showPage();
}

void Workbench::showPage() {
  if (before_) switchTo(View::Lesson);  // a view may still have the scene of a lesson
  switchTo(View::Picture);
  const Page& page = lecture_->now();
  begin(workOn(page.scene, page.setup));
  lessons_->forget();
  goTo(page.place);
  if (page.lesson) teach(*page.lesson);
  told_.clear();
  notice_.clear();
  server_.say(lecture_->title() + '\n' + (page.notes.empty() ? "" : page.notes + '\n'));
}

bool Workbench::turnsPage(const Key& key) {
  if (!lecture_) return false;
  lecture_->wait();
  const int pages = turning(key);
  if (pages == 0) return false;
  // Inside a lesson its steps come first.
  if (const Lesson* const lesson = lessons_->lesson();
      view() == View::Lesson && lesson && !lessons_->showsList()) {
    const int step = lessons_->step() + pages;
    if (step >= 0 && step < static_cast<int>(lesson->steps.size())) return false;
  }
  if (lecture_->turn(pages))
    showPage();
  else
    notify(pages > 0 ? "This is the last page of the lecture." : "This is the first page of the lecture.");
  return true;
}

}  // namespace xnewell
