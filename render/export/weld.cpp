#include "render/export/weld.h"

#include <utility>

#include "render/style/tissue_light.h"
#include "render/style/tissue_strength.h"

namespace pomona {

namespace {

double strength_of(const Solid& piece, std::int32_t part) {
  const auto number = static_cast<std::size_t>(part);
  const bool is_known = part >= 0 && number < piece.look->part_names.size();
  const Tissue usual = usual_tissue(is_known ? std::string_view(piece.look->part_names[number]) : "");
  return tissue_strength(material_of(piece, part).tissue.value_or(usual));
}

}  // namespace

std::string weld_name(const PieceContact& contact) {
  return "weld_" + std::to_string(contact.first + 1) + "_" + std::to_string(contact.second + 1) +
         (contact.cut == around_spared ? "_spared" : "_cut_" + std::to_string(contact.cut));
}

std::vector<Weld> welds_of(std::span<const Solid> pieces) {
  std::vector<Weld> welds;
  for (PieceContact& contact : contacts_of(pieces)) {
    const Solid& piece = pieces[static_cast<std::size_t>(contact.first)];
    Weld weld;
    weld.contact = std::move(contact);
    for (const auto& [pair, area] : weld.contact.parts) {
      const auto [first, second] = pair;
      weld.parts[strength_of(piece, second) < strength_of(piece, first) ? second : first] += area;
    }
    for (const auto& [part, area] : weld.parts) weld.strength += area * strength_of(piece, part);
    welds.push_back(std::move(weld));
  }
  return welds;
}

}  // namespace pomona
