#include "generator/scene/settle/item_starts.h"

#include <string>

#include "generator/base/error.h"

namespace pomona {

namespace {

[[noreturn]] void refuse(const SourcePlace& place, const std::string& message, const std::string& hint) {
  throw Error(ExitStatus::bad_data, {{place, message, hint}});
}

/// The pieces that one arrangement places.
std::vector<ArrangedPiece> pieces_of(const HeapPlan& plan, std::size_t arrangement) {
  std::vector<ArrangedPiece> pieces;
  for (std::size_t i = 0; i < plan.items().size(); ++i) {
    const SettleItem& item = plan.items()[i];
    if (item.arrangement != static_cast<int>(arrangement)) continue;
    const Attitude attitude = item.upright ? Attitude::upright : item.face_up ? Attitude::face_up : Attitude::any;
    pieces.push_back({i, &plan.shape(i), &plan.solid(i), attitude, item.fruit});
  }
  return pieces;
}

}  // namespace

void refuse_shallow_dish(const HeapPlan& plan) {
  if (plan.dish().holds()) return;
  for (std::size_t i = 0; i < plan.items().size(); ++i) {
    const SettleItem& item = plan.items()[i];
    if (item.beside || plan.is_placed(i)) continue;
    refuse(item.place, "\"" + plan.dish_name() + "\" has no hollow that could hold pieces",
           "lay them \"on\" it, or give it a rim");
  }
}

std::vector<std::optional<StartPose>> item_starts(const HeapPlan& plan) {
  std::vector<std::optional<StartPose>> starts(plan.items().size());
  const RandomStream draw = plan.draws("/arrange");
  const SettleOptions& options = plan.options();
  ArrangeOptions arranging{options.world, plan.unit(), plan.widest(), {}, options.threads};
  for (std::size_t k = 0; k < options.arrangements.size(); ++k) {
    const PieceArrangement& how = options.arrangements[k];
    if (how.kind == PieceArrangementKind::heap) continue;
    const std::vector<ArrangedPiece> pieces = pieces_of(plan, k);
    if (pieces.empty()) continue;
    if (how.kind == PieceArrangementKind::scatter && !has_upper_side(plan.dish()))
      refuse(plan.items()[pieces[0].piece].place,
             "\"" + plan.dish_name() + "\" has no area that looks upwards to scatter pieces on",
             "scatter them on a dish with a mesh");
    const auto found = arrange(pieces, how, plan.dish(), draw, arranging);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      starts[pieces[i].piece] = found[i];
      if (found[i]) arranging.obstacles.emplace_back(*pieces[i].shape, found[i]->rotation, found[i]->center);
    }
  }
  return starts;
}

}  // namespace pomona
