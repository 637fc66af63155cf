// Work that can be stopped from outside: by Ctrl-C in a program that Pomona is a part of.
#pragma once

#include <atomic>
#include <exception>

namespace pomona {

/// Ends work that was stopped. Nothing is wrong, and nothing is left behind.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// While it lives, the parallel loops of this thread, and the loops within them on other threads, end with Stopped as
/// soon as the flag is set: before their next item. Only whoever made the flag can tell; results do not depend on it.
class HeededStop {
 public:
  /// \param flag null: nothing stops the work.
  explicit HeededStop(const std::atomic<bool>* flag);
  ~HeededStop();
  HeededStop(const HeededStop&) = delete;
  HeededStop& operator=(const HeededStop&) = delete;

 private:
  const std::atomic<bool>* before_;
};

/// The flag that this thread heeds; null: none.
const std::atomic<bool>* heeded_stop();

/// \throws Stopped if the flag that this thread heeds is set.
void end_if_stopped();

}  // namespace pomona
