#include "generator/base/stopping.h"

#include <atomic>
#include <cstddef>

#include <gtest/gtest.h>

#include "generator/base/parallel.h"

namespace pomona {
namespace {

/// Number of items of a loop that begin if one of them asks for the stop.
std::size_t begun_until_stopped(Threads threads) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> begun = 0;
  const HeededStop heeded(&stop);
  EXPECT_THROW(parallel_for(1000, threads,
                            [&](std::size_t) {
                              ++begun;
                              stop = true;
                            }),
               Stopped);
  return begun;
}

TEST(Stopping, EndsALoopBeforeItsNextItem) {
  EXPECT_EQ(begun_until_stopped({1}), 1u);
  EXPECT_LE(begun_until_stopped({4}), 4u);
}

TEST(Stopping, EndsLoopsWithinLoopsOnOtherThreads) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> begun = 0;
  const HeededStop heeded(&stop);
  EXPECT_THROW(parallel_for(4, {4},
                            [&](std::size_t) {
                              parallel_for(1000, {1}, [&](std::size_t) {
                                ++begun;
                                stop = true;
                              });
                            }),
               Stopped);
  EXPECT_LE(begun, 4u);
}

TEST(Stopping, IsHeededNoLongerThanItsScopeAndOnItsThreadAlone) {
  std::atomic<bool> stop = true;
  {
    const HeededStop heeded(&stop);
    EXPECT_THROW(end_if_stopped(), Stopped);
    const HeededStop nothing(nullptr);
    EXPECT_NO_THROW(end_if_stopped());
  }
  EXPECT_NO_THROW(end_if_stopped());
  EXPECT_NO_THROW(parallel_for(100, {4}, [](std::size_t) { end_if_stopped(); })) << "threads have not kept the flag";
}

}  // namespace
}  // namespace pomona
