#include "app/interrupt.h"

#include <csignal>

namespace erg {
namespace {

// The only thing that a signal handler may touch.
volatile std::sig_atomic_t signal_came = 0;

extern "C" void note_signal(int) { signal_came = 1; }

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_came = 0;
  struct sigaction handler = {};
  handler.sa_handler = note_signal;
  handler.sa_flags = static_cast<int>(SA_RESETHAND);  // the second signal ends the program
  sigemptyset(&handler.sa_mask);
  sigaction(SIGINT, &handler, nullptr);
  sigaction(SIGTERM, &handler, nullptr);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() { return signal_came != 0; }

}  // namespace erg
