// Decimal numbers in files of text; independent of the locale.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace pomona {

/// The shortest decimal for the number rounded to multiples of `step`, a power of ten.
void append_number(std::string& text, double number, double step);

/// A number that reads back as the same bits.
std::string exact(double number);

/// "1 0.5 -2": the numbers of a vector to the last bit, with blanks between.
std::string exact_words(const glm::dvec3& v);

}  // namespace pomona
