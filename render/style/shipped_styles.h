// The files under styles/, as they were when the program was built.
#pragma once

#include <span>
#include <string_view>

namespace pomona {

struct ShippedStyle {
  std::string_view name;  ///< of the file, without folder and ending
  std::string_view text;
};

/// In the order of their names.
std::span<const ShippedStyle> shipped_styles();

}  // namespace pomona
