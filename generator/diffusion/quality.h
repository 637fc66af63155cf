// The quality of diffusion, and its names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// It determines only the error of the diffusion (docs/reference/diffusion.md has measurements).
enum class Quality { draft, final, reference };

/// The names, in the order of Quality.
inline std::vector<std::string> quality_names() { return {"draft", "final", "reference"}; }

inline std::string name_of(Quality quality) { return quality_names()[static_cast<std::size_t>(quality)]; }

/// The quality with this name, or nothing.
inline std::optional<Quality> quality_named(std::string_view name) {
  const std::vector<std::string> names = quality_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Quality>(found - names.begin());
}

}  // namespace pomona
