#include "generator/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <semaphore>
#include <thread>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "generator/base/stopping.h"

namespace pomona {

namespace {

/// TBB allows more threads than cores only while such an object exists; without it, TBB prints a warning.
std::optional<tbb::global_control> leave_for(int width) {
  if (width <= tbb::info::default_concurrency()) return {};
  return std::make_optional<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                 static_cast<std::size_t>(width));
}

/// threads_given(), called once for each width. TBB keeps its threads, and ends the program if the system refuses one.
int threads_had(int width) {
  static std::mutex mutex;
  static std::map<int, int> given;
  const std::lock_guard lock(mutex);
  const auto known = given.find(width);
  return known != given.end() ? known->second : given.emplace(width, threads_given(width)).first->second;
}

/// Calls run() in a TBB arena for this many threads. A new arena waits 70 microseconds for its threads, longer than
/// most steps on a grid take. So if the calling thread is already in an arena of that width, that one is used. The call
/// is isolated: a thread that waits for the last item of an inner loop must not start an item of the outer loop,
/// because then the memory of two outer items would be in use.
template <typename Run>
void among_threads(int width, const Run& run) {
  if (tbb::this_task_arena::max_concurrency() == width) {
    tbb::this_task_arena::isolate(run);
    return;
  }
  const std::optional<tbb::global_control> leave = leave_for(width);
  tbb::task_arena arena(width);
  arena.execute(run);
}

}  // namespace

int threads_given(int width) {
  // Each thread also allocates memory, so that glibc makes its heap before the next thread is tried. The stacks and
  // heaps of threads that have ended are kept for later threads.
  std::latch all_tried(1);
  std::binary_semaphore has_memory(0);
  std::vector<std::unique_ptr<int>> taken(static_cast<std::size_t>(width));
  std::vector<std::jthread> tried;
  try {
    while (std::ssize(tried) + 1 < width) {
      tried.emplace_back([&, &own = taken[tried.size()]] {
        own.reset(new (std::nothrow) int);
        has_memory.release();
        all_tried.wait();
      });
      has_memory.acquire();
    }
  } catch (const std::exception&) {
    // The system refuses more: use those that there are.
  }
  all_tried.count_down();
  return static_cast<int>(tried.size()) + 1;
}

int resolved(Threads threads) {
  if (threads.count > 0) return threads.count;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, Threads threads, const std::function<void(std::size_t)>& body) {
  const int wanted = std::min(resolved(threads), max_threads);
  const int width = wanted == 1 || count < 2 ? 1 : threads_had(wanted);
  if (width == 1) {
    for (std::size_t i = 0; i < count; ++i) {
      end_if_stopped();
      body(i);
    }
    return;
  }

  // Keep the failure of the smallest item, so that the message does not depend on the threads either.
  std::mutex mutex;
  std::size_t failed = std::numeric_limits<std::size_t>::max();
  std::exception_ptr failure;
  std::atomic<std::size_t> next = 0;
  const std::atomic<bool>* const stop = heeded_stop();
  among_threads(width, [&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t) {
      const std::size_t i = next++;
      try {
        const HeededStop heeded(stop);
        end_if_stopped();
        body(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (i < failed) {
          failed = i;
          failure = std::current_exception();
        }
      }
    });
  });
  if (failure) std::rethrow_exception(failure);
}

}  // namespace pomona
