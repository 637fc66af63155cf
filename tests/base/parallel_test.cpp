#include "generator/base/parallel.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace pomona {
namespace {

/// Number of loop bodies that run at once, if each waits for the others for a limited time.
std::size_t met_at_once(std::size_t count, Threads threads) {
  std::mutex mutex;
  std::condition_variable all_here;
  std::size_t inside = 0, max = 0;
  parallel_for(count, threads, [&](std::size_t) {
    std::unique_lock lock(mutex);
    max = std::max(max, ++inside);
    all_here.notify_all();
    all_here.wait_for(lock, std::chrono::seconds(20), [&] { return max == count; });
    --inside;
  });
  return max;
}

TEST(Parallel, HasAsManyThreadsAsAskedForAlsoBeyondTheCores) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(met_at_once(5, {5}), 5u);
  EXPECT_EQ(met_at_once(40, {40}), 40u);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "TBB warns of more workers than cores";
}

TEST(Parallel, DoesEachOnceHoweverManyThreadsAreAskedFor) {
  testing::internal::CaptureStderr();
  for (const int threads : {0, 1, 2, 16, 1000000}) {
    std::vector<int> done(1000);
    parallel_for(done.size(), {threads}, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(1000, 1)) << threads;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// Whether a thread has begun an item of a loop before it finished another item of that loop.
bool holds_two_items_at_once(Threads threads) {
  static thread_local int depth = 0;
  std::atomic<bool> is_nested = false;
  parallel_for(24, threads, [&](std::size_t) {
    if (++depth > 1) is_nested = true;
    parallel_for(8, threads,
                 [](std::size_t i) { std::this_thread::sleep_for(std::chrono::microseconds(i % 4 * 300)); });
    --depth;
  });
  return is_nested;
}

TEST(Parallel, AThreadThatWaitsForAnInnerLoopBeginsNoOtherItemOfTheOuterOne) {
  for (const int threads : {0, 2, 3, 8}) {
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(holds_two_items_at_once({threads})) << threads;
  }
}

TEST(Parallel, TellsOfTheFirstThatFailed) {
  for (const int threads : {0, 1, 16}) {
    try {
      parallel_for(100, {threads}, [&](std::size_t i) {
        if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7") << threads;
    }
  }
}

}  // namespace
}  // namespace pomona
