// Parallel loops whose result does not depend on the number of threads: item i writes slot i.
#pragma once

#include <cstddef>
#include <functional>

namespace pomona {

/// How many threads a step may use; 0 means as many as the machine has.
struct Threads {
  int count = 0;
};

int resolved(Threads threads);

/// The number of threads that the system really allows at once, at most `width`, the calling thread included. There are
/// fewer under a limit on processes or on address space, as each thread needs a stack. Starts the threads to find out.
int threads_given(int width);

/// More threads than this are never used.
constexpr int max_threads = 256;

/// Calls body(i) once for each i in [0, count), on up to `threads` threads, at most `max_threads`. There may be more
/// threads than cores, and fewer if the system does not allow as many. The body must write only to places that belong
/// to i. Items start in order of i; if few take long, put the longest first. If bodies throw, the exception of the
/// smallest i is rethrown.
void parallel_for(std::size_t count, Threads threads, const std::function<void(std::size_t)>& body);

}  // namespace pomona
