#include "render/export/piece_groups.h"

#include <map>

namespace pomona {

namespace {

/// The member of this name, which is made if necessary.
PieceGroup& group_in(PieceGroup& parent, const std::string& name, std::map<std::string, PieceGroup*>& known) {
  PieceGroup*& group = known[name];
  if (group == nullptr) {
    parent.members.push_back({0, std::make_shared<PieceGroup>(PieceGroup{name, {}})});
    group = parent.members.back().group.get();
  }
  return *group;
}

}  // namespace

PieceGroup grouped(std::span<const PiecePath> pieces) {
  std::map<std::string, std::size_t> of_variant;
  for (const PiecePath& piece : pieces) ++of_variant[piece.variant];

  PieceGroup all;
  std::map<std::string, PieceGroup*> entries, variants;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& [entry, variant] = pieces[i];
    PieceGroup* parent = entry.empty() ? &all : &group_in(all, entry, entries);
    const bool has_company = !variant.empty() && variant != entry && of_variant[variant] > 1;
    if (has_company) parent = &group_in(*parent, variant, variants);
    parent->members.push_back({i, nullptr});
  }
  return all;
}

}  // namespace pomona
