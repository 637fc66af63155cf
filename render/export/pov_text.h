// Numbers and words as POV-Ray's scene language wants them.
#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

namespace pomona::pov {

/// The shortest decimals that read back as the same number; no locale has a say.
std::string number_text(double number);

/// "<1, 0.5, -2>"
std::string vector_text(const glm::dvec3& v);

/// Appends "12", and "<1,-2,3>": what meshes consist of.
void append_integer(std::string& text, std::int64_t number);
void append_integers(std::string& text, std::int64_t x, std::int64_t y, std::int64_t z);

/// 10^exponent, correctly rounded.
double power_of_ten(int exponent);

/// The exponent that brings `size` into [10^digits, 10^(digits + 1)) when divided by its power of ten.
int exponent_for(double size, int digits);

/// What may stand in a comment that ends with the line.
std::string commentable(std::string text);

/// The text between double quotes, with what is special in it escaped.
std::string quoted(const std::string& text);

}  // namespace pomona::pov
