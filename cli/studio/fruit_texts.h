// The two texts of a fruit that is edited.
#pragma once

#include <string>

namespace pomona {

struct FruitTexts {
  std::string toml;
  std::string svg;  ///< empty if the template has its curves itself

  bool operator==(const FruitTexts&) const = default;
};

}  // namespace pomona
