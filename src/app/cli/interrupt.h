// Ctrl-C, a terminal that is closed, a system that shuts down: they ask the program to end in order.
#pragma once

#include <csignal>
#include <vector>

namespace erg::app {

/// While one of these lives, SIGINT, SIGTERM and SIGHUP set a flag instead of ending the program; a second
/// SIGINT or SIGTERM ends it at once, as if nobody had listened. What was ignored when it was made (`nohup`) stays
/// ignored.
class InterruptGuard {
 public:
  InterruptGuard();
  /// Whoever listened before listens again.
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// True once a signal came.
  static bool interrupted();

 private:
  struct Before {
    int signal;
    struct sigaction handler;
  };
  std::vector<Before> before_;
};

}  // namespace erg::app
