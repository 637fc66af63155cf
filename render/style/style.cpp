#include "render/style/style.h"

#include "generator/base/error.h"

namespace pomona {

std::vector<Style> all_styles() {
  const Style ink{.name = "ink"};
  Style plain{.name = "plain"};
  plain.noise = false;
  plain.ink = false;
  plain.grain = 0;
  plain.gloss = 0;
  return {ink, plain};
}

Style style_named(std::string_view name) {
  std::string names;
  for (const Style& style : all_styles()) {
    if (style.name == name) return style;
    names += (names.empty() ? "" : ", ") + style.name;
  }
  throw Error(ExitStatus::usage, "there is no style \"" + std::string(name) + "\"", "styles are: " + names);
}

}  // namespace pomona
