#include "generator/scene/settle/faults.h"

#include <algorithm>
#include <cstdio>

namespace pomona {

std::optional<Fault> fault_of(std::size_t piece, const Fit& fit, const SettleOptions& options) {
  const bool is_severe = std::max(fit.gap, fit.penetration) > options.max_rare_fault;
  char text[96] = "";
  if (fit.gap > options.max_gap) std::snprintf(text, sizeof text, "keeps a gap of %.1f %% of its size", 100 * fit.gap);
  if (fit.penetration > options.max_penetration)
    std::snprintf(text, sizeof text, "overlaps by %.1f %% of its size", 100 * fit.penetration);
  if (text[0] == '\0') return {};
  return Fault{piece, text, is_severe};
}

bool are_acceptable(const std::vector<Fault>& faults, std::size_t pieces, const SettleOptions& options) {
  const bool some_are_severe = std::any_of(faults.begin(), faults.end(), [](const Fault& f) { return f.is_severe; });
  return !some_are_severe && faults.size() * options.rare_in <= pieces;
}

void give_up(const std::vector<Fault>& faults, std::span<const SettleItem> items) {
  constexpr std::size_t max_listed = 5;
  std::string message = "the pieces do not settle: ";
  for (std::size_t i = 0; i < std::min(faults.size(), max_listed); ++i)
    message += (i > 0 ? "; " : "") + ("piece \"" + items[faults[i].piece].name + "\" " + faults[i].what);
  if (faults.size() > max_listed) message += "; and " + std::to_string(faults.size() - max_listed) + " more";
  throw Error(ExitStatus::some_items_failed,
              {{items[faults[0].piece].place, message, "a wider dish, fewer pieces or another seed may help"}});
}

}  // namespace pomona
