// Work shared among threads so that the result cannot depend on their number: item i writes slot i.
#pragma once

#include <cstddef>
#include <functional>

namespace pomona {

/// How many threads a step may use; 0 means as many as the machine has.
struct Threads {
  int count = 0;
};

int resolved(Threads threads);

/// How many threads there can be at once, up to `width`, the calling one included: fewer where a limit on processes, or
/// on addresses, of which a stack takes some, has the system refuse them. Starts them, and lets them go.
int threads_given(int width);

/// What is asked for beyond is left idle.
constexpr int most_threads = 256;

/// Calls body(i) for i in [0, count), each once, on up to `threads` threads, at most `most_threads`, which may be more
/// than there are cores; where the system gives fewer, they must do. The body must write only to places that belong to
/// i. They are begun in order: few long ones are shared best if the longest come first. The exception of the smallest
/// failing i is rethrown.
void parallel_for(std::size_t count, Threads threads, const std::function<void(std::size_t)>& body);

}  // namespace pomona
