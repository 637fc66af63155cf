// The signals with which people and schedulers end a program: SIGINT, SIGTERM and SIGHUP.
#pragma once

namespace pomona {

/// From now on these signals end the program at once, whichever thread they reach, except while HeldSignals lives.
/// A signal that is ignored (nohup) stays ignored. SIGXFSZ ends
/// nothing any more. Called once, before there are threads.
void heed_ending_signals();

/// Holds them back, in all threads. One that has come in the meantime ends the program when the last of these goes.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether one has come.
  bool any() const;

  /// What it asks for has been done: it need not end the program any more.
  void forget();
};

}  // namespace pomona
