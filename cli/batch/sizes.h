// What `pomona batch` is told in words: shards and sizes of memory.
#pragma once

#include <cstdint>
#include <string>

#include "cli/batch/workplace.h"

namespace pomona {

constexpr int max_shards = 1'000'000;

/// "3/8"; "" is the whole. \throws Error (usage) for what is none, and for a number out of range.
Shard parse_shard(const std::string& text);

/// "2GB", "500MB": bytes, by thousands; "" is 0. \throws Error (usage)
std::uint64_t parse_memory(const std::string& text);

}  // namespace pomona
