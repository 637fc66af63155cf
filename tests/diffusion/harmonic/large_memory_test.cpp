#include "generator/diffusion/harmonic/large_memory.h"

#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(RawArray, HoldsWhatWasWrittenAndGoesWhereItIsMoved) {
  RawArray<int> first(3);
  for (int i = 0; i < 3; ++i) first[static_cast<std::size_t>(i)] = 10 * i;
  EXPECT_EQ(first.bytes(), 3 * sizeof(int));
  const RawArray<int> second = std::move(first);
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[2], 20);
  EXPECT_EQ(second.data() + 1, &second[1]);
  EXPECT_EQ(RawArray<int>().size(), 0u);
}

TEST(LargeMemory, HoldsArraysOfAnySize) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1} << 19, (std::size_t{1} << 20) + 7}) {
    RawArray<std::uint32_t> array(size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % 64, 0u) << "what is aligned for caches is for anything";
    for (std::size_t i = 0; i < size; ++i) array[i] = static_cast<std::uint32_t>(i);
    std::vector<std::uint32_t, LargeAllocator<std::uint32_t>> grown;
    for (std::size_t i = 0; i < size; ++i) grown.push_back(array[i]);
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(grown[i], i);
  }
}

TEST(LargeMemory, RefusesWhatNoMachineHas) {
  EXPECT_THROW(allocate_large(~std::size_t{0} - 100), std::bad_alloc);
  std::vector<std::uint64_t, LargeAllocator<std::uint64_t>> vector;
  EXPECT_THROW(vector.get_allocator().allocate(~std::size_t{0} / 4), std::bad_array_new_length);
}

}  // namespace
}  // namespace pomona
