// Reads option values of `pomona batch`: shards and sizes of memory.
#pragma once

#include <cstdint>
#include <string>

#include "cli/batch/workplace.h"

namespace pomona {

constexpr int max_shards = 1'000'000;

/// Reads "3/8"; "" is the whole batch. \throws Error (usage) for anything else, and for a number out of range.
Shard parse_shard(const std::string& text);

/// Reads "2GB", "500MB" as bytes, in powers of 1000; "" is 0. \throws Error (usage)
std::uint64_t parse_memory(const std::string& text);

}  // namespace pomona
