#include "app/cli/interrupt.h"

namespace erg::app {
namespace {

// The only thing that a signal handler may touch.
volatile std::sig_atomic_t signal_came = 0;
volatile std::sig_atomic_t asked_to_end = 0;

extern "C" void note_signal(int signal) {
  signal_came = 1;
  if (signal == SIGHUP) return;  // of a terminal that closes it may come twice, or beside another
  if (asked_to_end != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // comes when this returns
  }
  asked_to_end = 1;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_came = 0;
  asked_to_end = 0;
  struct sigaction handler = {};
  handler.sa_handler = note_signal;
  handler.sa_flags = SA_RESTART;
  sigemptyset(&handler.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Before before{signal, {}};
    sigaction(signal, nullptr, &before.handler);
    if (before.handler.sa_handler == SIG_IGN) continue;
    sigaction(signal, &handler, nullptr);
    before_.push_back(before);
  }
}

InterruptGuard::~InterruptGuard() {
  for (const Before& before : before_) sigaction(before.signal, &before.handler, nullptr);
}

bool InterruptGuard::interrupted() { return signal_came != 0; }

}  // namespace erg::app
