#pragma once

#include <unistd.h>

#include <iostream>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <tuple>

#include "geometry/files/parse_error.h"

namespace xnewell {

/// On a terminal, shows what is being done for as long as it lasts. Silent anywhere else.
class Doing {
 public:
  explicit Doing(const std::string& what) : told_{::isatty(STDERR_FILENO) == 1} {
    if (told_) std::cerr << "xnewell: " << visible(what) << " ..." << std::flush;
  }
  Doing(const Doing&) = delete;
  Doing& operator=(const Doing&) = delete;
  ~Doing() {
    if (told_) std::ignore = ::write(STDERR_FILENO, "\r\033[K", 4);  // go to the line's start and clear it
  }

 private:
  bool told_;
};

/// Lets the program end by itself after an interrupt (SIGINT), so that it can tell what it has done: from now
/// on the first one only makes wasInterrupted() true. A second one ends the program.
void awaitInterrupt();
[[nodiscard]] bool wasInterrupted();

/// Shows what is written to a stream, for as long as the object lives: of all control characters only the end
/// of a line passes (visible.h).
class VisibleStream : std::streambuf {
 public:
  explicit VisibleStream(std::ostream& stream) : stream_{stream}, to_{stream.rdbuf(this)} {}
  VisibleStream(const VisibleStream&) = delete;
  VisibleStream& operator=(const VisibleStream&) = delete;
  ~VisibleStream() override { stream_.rdbuf(to_); }

 private:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    for (std::string_view rest{text, static_cast<std::size_t>(size)}; !rest.empty();) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      const bool ends = line.size() < rest.size();
      if (!putVisible(line, *to_) || (ends && to_->sputc('\n') != '\n')) return 0;
      rest.remove_prefix(line.size() + (ends ? 1 : 0));
    }
    return size;
  }
  int_type overflow(int_type c) override {
    const char one = traits_type::to_char_type(c);
    return xsputn(&one, 1) == 1 ? traits_type::not_eof(c) : traits_type::eof();
  }
  int sync() override { return to_->pubsync(); }

  std::ostream& stream_;
  std::streambuf* to_;
};

/// Makes memory cheap that one picture frees and the next one takes: what glibc gives back to the system
/// costs a fault for each page that is touched again. A moving view of 64,800 triangles has four times as
/// many faults without this.
///
/// A program that has this file also asks Linux for huge pages in large blocks of memory. A fault then brings
/// 512 pages at once.
void keepFreedMemory();

}  // namespace xnewell
