#include "app/interrupt.h"

namespace erg {
namespace {

// The only thing that a signal handler may touch.
volatile std::sig_atomic_t signal_came = 0;

extern "C" void note_signal(int signal) {
  if (signal_came != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // comes when this returns
  }
  signal_came = 1;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_came = 0;
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

}  // namespace erg
