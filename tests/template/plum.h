// The plum of good.toml, with text added at its end.
#pragma once

#include <span>
#include <string>

#include "generator/template/template.h"

namespace pomona {

Template plum_and(const std::string& more);

/// A text after good.toml that has a mistake.
struct Mistake {
  const char* text;
  int line, column;  ///< in it
  const char* message;
};

/// Expects the error bad_data for each; its first message has this place and these words.
void expect_found(std::span<const Mistake> mistakes);

}  // namespace pomona
