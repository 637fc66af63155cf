// Reads a stream up to a limit.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace pomona {

/// The rest of the stream, but at most `max` bytes. Pass the limit + 1 to find out whether a file is larger than a
/// limit. Memory grows with the bytes read, not with the limit.
std::string first_bytes(std::istream& stream, std::size_t max);

}  // namespace pomona
