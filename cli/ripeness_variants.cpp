#include "cli/ripeness_variants.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/piece/recolored.h"
#include "generator/piece/section_colors.h"

namespace pomona {

std::vector<double> wanted_ripenesses(const SharedOptions& options) {
  std::vector<double> wanted;
  if (options.ripeness_variants.empty()) return wanted;
  const std::string said = "--ripeness-variants " + options.ripeness_variants;
  if (!wants_textures(options)) throw Error(ExitStatus::usage, said + ": they are textures", "add --texture 512");
  if (options.lod > 0) throw Error(ExitStatus::usage, said + ": levels of detail have none", "leave out --lod");
  std::istringstream words(options.ripeness_variants + ",");
  for (std::string word; std::getline(words, word, ',');) {
    const std::optional<double> ripeness = parse_number(word);
    const bool is_new = ripeness && std::find(wanted.begin(), wanted.end(), *ripeness) == wanted.end();
    if (!is_new || !(*ripeness >= 0 && *ripeness <= 2) || wanted.size() == 16) {
      throw Error(ExitStatus::usage, said + ": \"" + word + "\" is no further ripeness",
                  "write up to 16 numbers from 0 to 2, as in 0.3,1,1.7");
    }
    wanted.push_back(*ripeness);
  }
  return wanted;
}

std::vector<RipenessVariant> ripeness_variants(std::span<const Solid> pieces, const FruitSource& source,
                                               const std::string& fruit, const SharedOptions& options,
                                               std::optional<int> folds, const Diffuser* diffuser, StageTimes& times) {
  std::vector<RipenessVariant> variants;
  for (const double ripeness : wanted_ripenesses(options)) {
    SharedOptions at = options;
    at.ripeness = ripeness;
    const FruitSource riper = open_fruit(fruit, at, folds, times);
    std::ostringstream name;
    name << "ripeness " << ripeness;
    RipenessVariant variant{name.str(), {}};
    const auto colors =
        diffuser ? std::make_shared<const SectionColors>(riper.grown.sheets, riper.fruit, *diffuser) : nullptr;
    for (const Solid& piece : pieces) {
      variant.pieces.push_back(recolored(piece, source.grown.swept, riper.grown.swept));
      variant.pieces.back().section_colors = colors;
    }
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace pomona
