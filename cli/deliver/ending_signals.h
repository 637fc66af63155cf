// The signals with which people and schedulers end a program: SIGINT, SIGTERM and SIGHUP.
#pragma once

namespace pomona {

/// From now on these signals end the program at once, in whichever thread they arrive, unless HeldSignals exists. A
/// signal that is ignored (nohup) stays ignored. SIGXFSZ is ignored from now on. Called once, before there are threads.
void heed_ending_signals();

/// Delays the signals, in all threads. A signal that has arrived ends the program when the last object of this class is
/// destroyed.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// True if a signal has arrived.
  bool any() const;

  /// Drops the signal: its request is fulfilled.
  void forget();
};

}  // namespace pomona
