#include "render/style/style.h"

#include "generator/base/error.h"
#include "generator/base/nearest_name.h"
#include "render/style/shipped_styles.h"
#include "render/style/style_file.h"

namespace pomona {

namespace {

Style read_shipped(const EmbeddedFile& shipped) {
  return parse_style(shipped.text, "styles/" + std::string(shipped.name));
}

}  // namespace

std::vector<Style> all_styles() {
  std::vector<Style> styles;
  for (const EmbeddedFile& shipped : shipped_styles()) styles.push_back(read_shipped(shipped));
  return styles;
}

Style style_named(std::string_view name) {
  std::vector<std::string> known;
  std::string names;
  for (const EmbeddedFile& shipped : shipped_styles()) {
    if (shipped.stem() == name) return read_shipped(shipped);
    known.emplace_back(shipped.stem());
    names += (names.empty() ? "" : ", ") + known.back();
  }
  const auto near = nearest_name(std::string(name), known);
  throw Error(ExitStatus::usage, "there is no style \"" + std::string(name) + "\"",
              (near ? "did you mean " + *near + "? " : "") + "styles are: " + names + "; a path to a .toml works too");
}

}  // namespace pomona
