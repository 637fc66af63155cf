// Lists of names, of which another list brings some.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pomona {

/// The index of each of `names` in `known`, to whose end missing names are added.
std::vector<std::int32_t> merge_names(std::vector<std::string>& known, const std::vector<std::string>& names);

}  // namespace pomona
