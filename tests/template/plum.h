// The plum of good.toml, with more at its end.
#pragma once

#include <span>
#include <string>

#include "generator/template/template.h"

namespace pomona {

Template plum_and(const std::string& more);

/// Text after good.toml in which something is wrong.
struct Mistake {
  const char* text;
  int line, column;  ///< in it
  const char* message;
};

/// Each must be bad data, told first of all, where it is, in these words.
void expect_found(std::span<const Mistake> mistakes);

}  // namespace pomona
