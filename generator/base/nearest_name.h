// "Did you mean ...?": for mistyped options, keys and names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pomona {

/// The known name with the smallest edit distance to `name`, if it is near enough to be meant.
std::optional<std::string> nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace pomona
