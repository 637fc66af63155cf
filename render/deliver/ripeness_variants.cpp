#include "render/deliver/ripeness_variants.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "generator/base/error.h"
#include "generator/piece/recolored.h"
#include "generator/piece/section_colors.h"

namespace pomona {

namespace {

/// Gives vertices of cut faces their colours at this ripeness, because textures read them around a face.
Solid with_cut_faces(Solid piece, const SectionColors& colors) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t t = 0; t < piece.mesh.triangle.size(); ++t) {
    if (piece.mesh.cut_face[t] < 0) continue;
    for (int k = 0; k < 3; ++k) numbers.push_back(piece.mesh.triangle[t][k]);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<glm::vec3> points;
  for (const std::uint32_t v : numbers) points.push_back(piece.mesh.position[v]);
  const DiffusedColors there = colors.field()->at(points);
  for (std::size_t i = 0; i < numbers.size(); ++i) piece.mesh.color[numbers[i]] = there.color[i];
  return piece;
}

}  // namespace

std::vector<RipenessVariant> ripeness_variants(std::span<const Solid> pieces, const OrderedFruit& fruit,
                                               const std::optional<Template>& drawn, const Order& order,
                                               const Diffuser* diffuser, StageClock& times) {
  std::vector<RipenessVariant> variants;
  if (order.mesh.ripeness_variants.empty()) return variants;
  if (!drawn)
    throw Error(ExitStatus::usage,
                "--ripeness-variants: " + fruit.file + " holds surfaces, which do not say how they ripen");
  for (const double ripeness : order.mesh.ripeness_variants) {
    Order at = order;
    at.fruit.growing.ripeness = ripeness;
    const OrderedFruit riper = ordered_fruit(*drawn, fruit.name, fruit.origin.source, at);
    times.add(riper.times);
    std::ostringstream name;
    name << "ripeness " << ripeness;
    RipenessVariant variant{name.str(), {}};
    const auto colors =
        diffuser ? std::make_shared<const SectionColors>(riper.grown.sheets, riper.fruit, *diffuser) : nullptr;
    for (const Solid& piece : pieces) {
      Solid same = recolored(piece, fruit.grown.swept, riper.grown.swept, riper.fruit);
      if (colors) same = with_cut_faces(std::move(same), *colors);
      same.section_colors = colors;
      variant.pieces.push_back(std::move(same));
    }
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace pomona
