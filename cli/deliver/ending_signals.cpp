#include "cli/deliver/ending_signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

namespace pomona {

namespace {

// A signal handler can only read variables with static lifetime.
constexpr int being_ended = -1;
std::atomic<int> holders = 0;  // number of HeldSignals; `being_ended` once a signal ends the program
std::atomic<int> arrived = 0;  // the signal that came while they were held; 0 = none
static_assert(std::atomic<int>::is_always_lock_free);

void end_or_keep(int signal) {
  int nobody = 0;
  if (holders.compare_exchange_strong(nobody, being_ended)) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);  // delivered as this handler returns
  } else if (nobody != being_ended) {
    arrived.store(signal);
  }
}

}  // namespace

void heed_ending_signals() {
  // Beyond a limit of file sizes (`ulimit -f`) write() fails, which is told and leaves nothing half done.
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction ours {};
    ours.sa_handler = end_or_keep;
    ours.sa_flags = SA_RESTART;
    ::sigaction(signal, &ours, nullptr);
  }
}

HeldSignals::HeldSignals() {
  int before = holders.load();
  do {
    while (before == being_ended) {
      ::pause();  // another thread is ending the program
      before = holders.load();
    }
  } while (!holders.compare_exchange_weak(before, before + 1));
}

HeldSignals::~HeldSignals() {
  if (--holders > 0) return;
  if (const int signal = arrived.exchange(0); signal != 0) ::raise(signal);
}

bool HeldSignals::any() const { return arrived.load() != 0; }

void HeldSignals::forget() { arrived.store(0); }

}  // namespace pomona
