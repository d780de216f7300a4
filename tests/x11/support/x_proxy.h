#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <compare>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/x11/support/x_server.h"

namespace xnewell {

/// A bad server made of a good one. It stands between programs and an X server, passes on and counts what
/// they say, and treats one chosen request as a server does that is out of memory, dying or hung. @see X
/// Window System Protocol, X11 Release 7.7, chapters 1, 8 and appendix B; Big Requests Extension

/// A request by its numbers: the major opcode and, for an extension, the minor one (0 for the core). Major 0,
/// which no request has, stands for the connection's setup.
struct XRequest {
  int major = 0, minor = 0;
  auto operator<=>(const XRequest&) const = default;
};
inline constexpr XRequest kConnectionSetup{};

/// What happens to a request.
enum class XFault {
  Refused,     ///< the server does not get it, and the program gets an error instead
  CutRequest,  ///< the connection ends when its first bytes have arrived
  CutReply,    ///< the connection ends within its reply, or the error in the place of one
  Stalled,     ///< from here on nothing goes either way, until one of the two is gone
  Deaf,        ///< the same, and what the program writes is an error: the end of the connection as its
               ///< writer sees it who has looked just before
};

struct XFaultPlan {
  XFault fault{};
  XRequest request;
  int occurrence = 1;  ///< counted from 1
  int error = 11;      ///< the code of Refused: BadAlloc
};

class XProxy {
 public:
  /// `latency` is the delay of a request and its reply together; each has half of it.
  explicit XProxy(const XServer& server, std::chrono::microseconds latency = {});
  ~XProxy();
  XProxy(const XProxy&) = delete;
  XProxy& operator=(const XProxy&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }  ///< as in ":600"

  /// From here on nobody gets a new connection. To be called before the server is stopped: another test's
  /// server may take the number that becomes free, and a program that tries again would find that one.
  void serverStops() { serverStops_ = true; }

  /// Forgets what was counted. `plan` is carried out at most once.
  void begin(const std::optional<XFaultPlan>& plan = {});
  /// All requests of all programs since begin(), oldest first.
  [[nodiscard]] std::vector<XRequest> requests() const;
  /// The requests that got a reply. Xlib waits for each reply, so the program made no more round trips.
  [[nodiscard]] std::vector<XRequest> answered() const;
  /// Whether the plan was carried out.
  [[nodiscard]] bool carriedOut() const;
  /// The name as xnewell gives it: "X_CreatePixmap", "MIT-SHM.1". A program must have asked for the
  /// extension.
  [[nodiscard]] std::string nameOf(const XRequest& request) const;

 private:
  using Time = std::chrono::steady_clock::time_point;
  /// Bytes on their way to one of the two ends, and the time when they are due.
  struct Parcel {
    Time due;
    std::string bytes;
  };
  /// One of the two ends of a connection.
  struct End {
    int socket = -1;
    std::string heard;           ///< bytes not yet understood
    std::vector<Parcel> owed{};  ///< on their way to this end, the oldest first
    bool greeted = false;        ///< its part of the setup is over
  };
  /// A program's connection.
  struct Link {
    End program, server;
    std::uint16_t sequence = 0;  ///< number of the last request, modulo 2^16
    std::vector<XRequest> sent = std::vector<XRequest>(1u << 16);  ///< by sequence numbers
    bool known = false;             ///< the request at the beginning of program.heard was counted
    std::optional<XFault> fault{};  ///< what becomes of it
    std::map<std::uint16_t, std::string> asked{};  ///< extensions
    std::optional<std::uint16_t> refused{}, cutReply{};
    bool stalled = false, over = false;
  };

  void run();
  void accept();
  void hear(End& end, Link& link);
  void pay(End& end, bool all);
  void takeRequests(Link& link);
  void takeAnswers(Link& link);
  [[nodiscard]] std::optional<XFault> countRequest(Link& link, const char* bytes);
  [[nodiscard]] std::string answerInstead(Link& link, std::string message);
  void owe(End& end, std::string bytes);

  std::string name_, path_, serverPath_;
  std::chrono::microseconds latency_;
  int listener_ = -1, stop_ = -1;
  std::atomic<bool> serverStops_ = false;
  std::vector<Link> links_;  ///< only the thread uses them

  mutable std::mutex mutex_;  ///< guards all that follows
  std::optional<XFaultPlan> plan_;
  int occurrences_ = 0;  ///< of the plan's request
  bool carriedOut_ = false;
  std::vector<XRequest> requests_, answered_;
  std::map<int, std::string> extensions_;

  std::thread thread_;
};

}  // namespace xnewell
