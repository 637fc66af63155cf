// A fruit as one edits it: two texts.
#pragma once

#include <string>

namespace pomona {

struct FruitTexts {
  std::string toml;
  std::string svg;  ///< empty where the template holds its curves itself

  bool operator==(const FruitTexts&) const = default;
};

}  // namespace pomona
