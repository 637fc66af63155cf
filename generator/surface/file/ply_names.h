// The names that comments of a PLY file give to its surfaces and parts.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

constexpr double max_ply_names = 65'536;

/// The names by index. The comment "surface 3 skin" names surface 3, where `what` is "surface "; other comments are
/// ignored. An index in use that has no name gets "surface 3".
std::vector<std::string> ply_names(const std::vector<std::string>& comments, std::string_view what,
                                   std::initializer_list<const std::vector<std::int32_t>*> used);

}  // namespace pomona
