// Limits of a batch.
#pragma once

#include <cstddef>

namespace pomona {

constexpr int max_batch_items = 10'000'000;
constexpr std::size_t max_batch_entries = 1000;

}  // namespace pomona
