// Lengths and angles as users write them.
#pragma once

#include <optional>
#include <string_view>

namespace pomona {

/// "4mm", "5cm", "0.05m" or "0.05" (metres); locale-independent. Nothing if it is not a finite length.
std::optional<double> parse_length(std::string_view text);

/// A finite decimal number that fills the whole text; locale-independent.
std::optional<double> parse_number(std::string_view text);

constexpr double pi = 3.14159265358979323846;

constexpr double radians(double degrees) { return degrees * (pi / 180.0); }

}  // namespace pomona
