#include "generator/diffusion/pmvc/aligned_array.h"

#include <cstdint>
#include <limits>
#include <new>

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(AlignedArray, BeginsWhereWideRegistersDo) {
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(aligned_array<float>(1000).get()) % HWY_ALIGNMENT, 0u);
}

TEST(AlignedArray, ThrowsWhereThereIsNoMemory) {
  EXPECT_THROW(aligned_array<float>(std::numeric_limits<std::size_t>::max() / 16), std::bad_alloc);
}

}  // namespace
}  // namespace pomona
