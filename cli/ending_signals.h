// The signals with which people and schedulers end a program.
#pragma once

#include <csignal>

namespace pomona {

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};

inline sigset_t set_of_ending_signals() {
  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : ending_signals) sigaddset(&ending, signal);
  return ending;
}

}  // namespace pomona
