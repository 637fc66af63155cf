// Numbers and texts for POV-Ray's scene language.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace pomona::pov {

/// "<1, 0.5, -2>"
std::string vector_text(const glm::dvec3& v);

/// Appends "12", or "<1,-2,3>", for meshes.
void append_integer(std::string& text, std::int64_t number);
void append_integers(std::string& text, std::int64_t x, std::int64_t y, std::int64_t z);

/// 10^exponent, correctly rounded.
double power_of_ten(int exponent);

/// The exponent that brings `size` into [10^digits, 10^(digits + 1)) when divided by its power of ten.
int exponent_for(double size, int digits);

/// The text, made safe for a one-line comment.
std::string commentable(std::string_view any_text);

/// The text between double quotes, with what is special in it escaped.
std::string quoted(const std::string& text);

}  // namespace pomona::pov
