// Files of other people, taken in as far as they may be long.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace pomona {

/// What the stream still holds, but no more than `most` bytes. One byte beyond a limit is enough to know that a file
/// goes beyond it. Memory grows with what is there, not with the limit.
std::string first_bytes(std::istream& stream, std::size_t most);

}  // namespace pomona
