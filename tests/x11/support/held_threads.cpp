#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>

// Linked before the C library: a thread of the program begins its work only while the gate of
// long_work_test.cpp is open. $XNEWELL_GATE names the gate's file.

namespace {

struct Start {
  void* (*routine)(void*);
  void* argument;
};

void* passGate(void* start) {
  const Start begin = *static_cast<Start*>(start);
  delete static_cast<Start*>(start);
  if (const char* const gate = std::getenv("XNEWELL_GATE")) {
    const int file = open(gate, O_RDONLY | O_CLOEXEC);
    flock(file, LOCK_SH);  // waits while the test holds it
    close(file);
  }
  return begin.routine(begin.argument);
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*routine)(void*),
                              void* argument) noexcept {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, passGate, new Start{routine, argument});
}
