// Ctrl-C: asks the run to stop after the step that it is in.
#pragma once

namespace erg {

/// While one of these lives, SIGINT and SIGTERM set a flag instead of ending the program. A second signal ends it at
/// once, as if nobody had listened.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// True once a signal came.
  static bool interrupted();
};

}  // namespace erg
