// "Did you mean ...?": for mistyped options, keys and names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pomona {

/// The known name with the smallest edit distance to `name`, capitals taken for small letters, if it is near enough to
/// be meant: a third of its letters may be wrong, two of five.
std::optional<std::string> nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace pomona
