#include "tests/x11/support/x_proxy.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <X11/Xlib.h>
#include <X11/Xproto.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace xnewell {

namespace {

const std::string kSockets = "/tmp/.X11-unix/X";
constexpr int kFirstDisplay = 600;  ///< where no server looks for a free number
constexpr std::size_t kAnswerSize = 32;

/// Programs here have this machine's byte order, so numbers are as they are in memory.
template <typename Number>
Number numberAt(const char* bytes) {
  Number n{};
  std::memcpy(&n, bytes, sizeof n);
  return n;
}

template <typename Number>
void put(std::string& bytes, std::size_t at, Number n) {
  std::memcpy(&bytes[at], &n, sizeof n);
}

constexpr std::size_t padded(std::size_t n) { return (n + 3) / 4 * 4; }

sockaddr_un addressOf(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  return address;
}

int newSocket() { return ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0); }

/// The number of bytes of the message that begins at `from` in `heard`, if enough of it is there to tell.
std::optional<std::size_t> requestSize(const std::string& heard, std::size_t from, bool greeted) {
  const char* bytes = heard.data() + from;
  const std::size_t there = heard.size() - from;
  if (!greeted) {
    if (there < sz_xConnClientPrefix) return std::nullopt;
    return sz_xConnClientPrefix + padded(numberAt<CARD16>(bytes + 6)) + padded(numberAt<CARD16>(bytes + 8));
  }
  if (there < 4) return std::nullopt;
  if (const std::size_t words = numberAt<CARD16>(bytes + 2); words > 0) return 4 * words;
  if (there < 8) return std::nullopt;  // a big request has its length in the next word
  return 4 * std::size_t{numberAt<CARD32>(bytes + 4)};
}

std::optional<std::size_t> answerSize(const std::string& heard, std::size_t from, bool greeted) {
  const char* bytes = heard.data() + from;
  const std::size_t there = heard.size() - from;
  if (!greeted) {
    if (there < sz_xConnSetupPrefix) return std::nullopt;
    return sz_xConnSetupPrefix + 4 * std::size_t{numberAt<CARD16>(bytes + 6)};
  }
  if (there < kAnswerSize) return std::nullopt;
  if (bytes[0] != X_Reply && bytes[0] != GenericEvent) return kAnswerSize;
  return kAnswerSize + 4 * std::size_t{numberAt<CARD32>(bytes + 4)};
}

/// A request with no effect but an answer, in its turn.
std::string askNothing() {
  std::string request(4, '\0');
  request[0] = X_GetInputFocus;
  put<CARD16>(request, 2, 1);
  return request;
}

std::string errorFor(const XRequest& request, std::uint16_t sequence, int code) {
  std::string error(kAnswerSize, '\0');
  error[0] = X_Error;
  error[1] = static_cast<char>(code);
  put<CARD16>(error, 2, sequence);
  put<CARD16>(error, 8, static_cast<CARD16>(request.minor));
  error[10] = static_cast<char>(request.major);
  return error;
}

/// From here on writing at the other end is an error. What lies in between is read, because a writer that
/// waits for room would not be told.
void turnDeaf(int socket) {
  shutdown(socket, SHUT_RD);
  std::array<char, 65536> bytes;
  while (recv(socket, bytes.data(), bytes.size(), 0) > 0) continue;
}

std::string refusedSetup() {
  const std::string reason = "no more clients here";
  std::string refusal(sz_xConnSetupPrefix, '\0');
  refusal[1] = static_cast<char>(reason.size());
  put<CARD16>(refusal, 2, X_PROTOCOL);
  put<CARD16>(refusal, 6, static_cast<CARD16>(padded(reason.size()) / 4));
  return refusal + reason + std::string(padded(reason.size()) - reason.size(), '\0');
}

}  // namespace

XProxy::XProxy(const XServer& server, std::chrono::microseconds latency)
    : serverPath_{kSockets + server.name().substr(1)}, latency_{latency} {
  listener_ = newSocket();
  for (int number = kFirstDisplay;; ++number) {
    path_ = kSockets + std::to_string(number);
    name_ = ":" + std::to_string(number);
    const sockaddr_un address = addressOf(path_);
    if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) break;
    if (errno != EADDRINUSE || number == kFirstDisplay + 1000)
      throw std::runtime_error("the proxy finds no free display");
  }
  listen(listener_, 8);
  stop_ = eventfd(0, EFD_CLOEXEC);
  thread_ = std::thread{[this] { run(); }};
}

XProxy::~XProxy() {
  const std::uint64_t one = 1;
  if (write(stop_, &one, sizeof one) == sizeof one) thread_.join();
  unlink(path_.c_str());
  close(listener_);
  close(stop_);
}

void XProxy::begin(const std::optional<XFaultPlan>& plan) {
  const std::lock_guard lock{mutex_};
  plan_ = plan;
  occurrences_ = 0;
  carriedOut_ = false;
  requests_.clear();
  answered_.clear();
}

std::vector<XRequest> XProxy::requests() const {
  const std::lock_guard lock{mutex_};
  return requests_;
}

std::vector<XRequest> XProxy::answered() const {
  const std::lock_guard lock{mutex_};
  return answered_;
}

bool XProxy::carriedOut() const {
  const std::lock_guard lock{mutex_};
  return carriedOut_;
}

std::string XProxy::nameOf(const XRequest& request) const {
  if (request == kConnectionSetup) return "setup";
  std::array<char, 128> text{};
  XGetErrorDatabaseText(nullptr, "XRequest", std::to_string(request.major).c_str(), "", text.data(),
                        text.size());
  if (text[0] != '\0') return text.data();
  const std::lock_guard lock{mutex_};
  const auto extension = extensions_.find(request.major);
  return (extension == extensions_.end() ? std::to_string(request.major) : extension->second) + "." +
         std::to_string(request.minor);
}

void XProxy::run() {
  for (;;) {
    std::vector<pollfd> waits{{stop_, POLLIN, 0}, {listener_, POLLIN, 0}};
    std::optional<Time> next;
    for (const Link& link : links_)
      for (const End* end : {&link.program, &link.server}) {
        waits.push_back({end->socket, static_cast<short>(link.stalled ? 0 : POLLIN), 0});
        if (!link.stalled && !end->owed.empty())
          next = std::min(next.value_or(end->owed[0].due), end->owed[0].due);
      }
    int patience = -1;
    if (next)
      patience = static_cast<int>(std::max<std::int64_t>(
          0, std::chrono::ceil<std::chrono::milliseconds>(*next - std::chrono::steady_clock::now()).count()));
    if (poll(waits.data(), waits.size(), patience) < 0 && errno != EINTR) return;
    if (waits[0].revents != 0) break;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      Link& link = links_[i];
      const bool fromProgram = waits[2 + 2 * i].revents != 0, fromServer = waits[3 + 2 * i].revents != 0;
      if (link.stalled) {
        link.over = fromProgram || fromServer;  // one of the two hung up
        continue;
      }
      if (fromProgram) hear(link.program, link);
      if (fromServer) hear(link.server, link);
      takeRequests(link);
      takeAnswers(link);
      for (End* end : {&link.program, &link.server}) pay(*end, /*all=*/link.over);
    }
    if (waits[1].revents != 0) accept();
    std::erase_if(links_, [](const Link& link) {
      if (!link.over) return false;
      close(link.program.socket);
      close(link.server.socket);
      return true;
    });
  }
  for (const Link& link : links_) {
    close(link.program.socket);
    close(link.server.socket);
  }
}

void XProxy::accept() {
  Link link;
  link.program.socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  link.server.socket = newSocket();
  const sockaddr_un address = addressOf(serverPath_);
  link.over = serverStops_ ||
              connect(link.server.socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0;
  links_.push_back(std::move(link));
}

void XProxy::hear(End& end, Link& link) {
  std::array<char, 65536> bytes;
  const ssize_t n = recv(end.socket, bytes.data(), bytes.size(), 0);
  if (n > 0)
    end.heard.append(bytes.data(), static_cast<std::size_t>(n));
  else
    link.over = true;
}

void XProxy::owe(End& end, std::string bytes) {
  end.owed.push_back({std::chrono::steady_clock::now() + latency_ / 2, std::move(bytes)});
}

/// Both ends always read while they write, so this does not wait for long.
void XProxy::pay(End& end, bool all) {
  const Time now = std::chrono::steady_clock::now();
  const auto later = std::find_if(end.owed.begin(), end.owed.end(),
                                  [&](const Parcel& parcel) { return !all && parcel.due > now; });
  std::for_each(end.owed.begin(), later, [&](const Parcel& parcel) {
    for (std::size_t sent = 0; sent < parcel.bytes.size();) {
      const ssize_t n =
          send(end.socket, parcel.bytes.data() + sent, parcel.bytes.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) return;  // the end is gone, which hear() will notice
      sent += static_cast<std::size_t>(n);
    }
  });
  end.owed.erase(end.owed.begin(), later);
}

std::optional<XFault> XProxy::countRequest(Link& link, const char* bytes) {
  XRequest request = kConnectionSetup;
  if (link.program.greeted) {
    ++link.sequence;
    request.major = static_cast<unsigned char>(bytes[0]);
    if (request.major >= 128) request.minor = static_cast<unsigned char>(bytes[1]);
  }
  link.sent[link.sequence] = request;
  const std::lock_guard lock{mutex_};
  requests_.push_back(request);
  if (!plan_ || plan_->request != request || ++occurrences_ != plan_->occurrence) return std::nullopt;
  carriedOut_ = true;
  if (plan_->fault == XFault::Refused) link.refused = link.sequence;
  if (plan_->fault == XFault::CutReply) link.cutReply = link.sequence;
  return plan_->fault;
}

void XProxy::takeRequests(Link& link) {
  std::string& heard = link.program.heard;
  std::size_t from = 0;
  while (!link.over && !link.stalled) {
    const std::optional<std::size_t> size = requestSize(heard, from, link.program.greeted);
    if (!size) break;
    if (!std::exchange(link.known, true)) link.fault = countRequest(link, heard.data() + from);
    link.over = link.fault == XFault::CutRequest;
    link.stalled = link.fault == XFault::Stalled || link.fault == XFault::Deaf;
    if (link.fault == XFault::Deaf) turnDeaf(link.program.socket);
    if (link.over || link.stalled || heard.size() - from < *size) break;

    std::string request = heard.substr(from, *size);
    from += *size;
    link.known = false;
    const bool refused = link.fault == XFault::Refused;
    if (!std::exchange(link.program.greeted, true)) {
      if (refused) {
        owe(link.program, refusedSetup());
        link.over = true;
        break;
      }
    } else if (refused) {
      request = askNothing();
    } else if (request[0] == X_QueryExtension) {
      link.asked[link.sequence] = request.substr(sz_xQueryExtensionReq, numberAt<CARD16>(&request[4]));
    }
    owe(link.server, std::move(request));
  }
  heard.erase(0, from);
}

void XProxy::takeAnswers(Link& link) {
  std::string& heard = link.server.heard;
  std::size_t from = 0;
  while (!link.stalled) {
    const std::optional<std::size_t> size = answerSize(heard, from, link.server.greeted);
    if (!size || heard.size() - from < *size) break;
    std::string answer = heard.substr(from, *size);
    from += *size;
    const bool setup = !std::exchange(link.server.greeted, true);
    const auto sequence = setup ? std::uint16_t{0} : numberAt<CARD16>(&answer[2]);
    if (link.cutReply == sequence && (setup || answer[0] == X_Reply || answer[0] == X_Error)) {
      owe(link.program, answer.substr(0, answer.size() / 2));
      link.over = true;
      break;
    }
    if (!setup && answer[0] == X_Reply) answer = answerInstead(link, std::move(answer));
    owe(link.program, std::move(answer));
  }
  heard.erase(0, from);
}

std::string XProxy::answerInstead(Link& link, std::string message) {
  const auto sequence = numberAt<CARD16>(&message[2]);
  const std::lock_guard lock{mutex_};
  if (link.refused == sequence) {
    link.refused.reset();
    return errorFor(link.sent[sequence], sequence, plan_ ? plan_->error : BadAlloc);
  }
  answered_.push_back(link.sent[sequence]);
  if (const auto asked = link.asked.find(sequence); asked != link.asked.end() && message[8] != 0)
    extensions_[static_cast<unsigned char>(message[9])] = asked->second;
  return message;
}

}  // namespace xnewell
