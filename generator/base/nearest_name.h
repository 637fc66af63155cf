// "Did you mean ...?": for mistyped options, keys and names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pomona {

/// The known name with the smallest edit distance to `name`, if at most a third of its letters are wrong, or two of
/// five. Capitals count as small letters.
std::optional<std::string> nearest_name(const std::string& name, const std::vector<std::string>& known);

/// "did you mean ...?" if a known name is near, else all known names; empty if none is known.
std::string name_hint(const std::string& name, std::vector<std::string> known);

}  // namespace pomona
