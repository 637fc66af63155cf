#include "generator/base/stopping.h"

namespace pomona {

namespace {

// Handed down by scopes, from a thread to those that work for it (parallel.cpp). It would else be a parameter of every
// function of the road, and change no result of any.
thread_local const std::atomic<bool>* heeded = nullptr;

}  // namespace

HeededStop::HeededStop(const std::atomic<bool>* flag) : before_(heeded) { heeded = flag; }

HeededStop::~HeededStop() { heeded = before_; }

const std::atomic<bool>* heeded_stop() { return heeded; }

void end_if_stopped() {
  if (heeded != nullptr && heeded->load(std::memory_order_relaxed)) throw Stopped();
}

}  // namespace pomona
