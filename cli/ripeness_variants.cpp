#include "cli/ripeness_variants.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/piece/recolored.h"
#include "generator/piece/section_colors.h"

namespace pomona {

namespace {

/// The vertices of cut faces as they are at this ripeness: textures take from them what lies around a face.
Solid with_cut_faces(Solid piece, const SectionColors& colors) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t t = 0; t < piece.triangle.size(); ++t) {
    if (piece.cut_face[t] < 0) continue;
    for (int k = 0; k < 3; ++k) numbers.push_back(piece.triangle[t][k]);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<glm::vec3> points;
  for (const std::uint32_t v : numbers) points.push_back(piece.position[v]);
  const DiffusedColors there = colors.field()->at(points);
  for (std::size_t i = 0; i < numbers.size(); ++i) piece.color[numbers[i]] = there.color[i];
  return piece;
}

}  // namespace

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
      Solid same = recolored(piece, source.grown.swept, riper.grown.swept, riper.fruit);
      if (colors) same = with_cut_faces(std::move(same), *colors);
      same.section_colors = colors;
      variant.pieces.push_back(std::move(same));
    }
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace pomona
