#include "generator/variation/fold_draw.h"

#include <algorithm>
#include <string>

#include "generator/variation/fold_pca.h"

namespace pomona {

std::vector<FoldDraw> drawn_folds(std::size_t samples, VariantKey key, double amount, int folds) {
  std::vector<FoldDraw> draws;
  for (int k = 0; k < folds; ++k) {
    const RandomStream stream(key, "vary/fold/" + std::to_string(k));
    FoldDraw draw{{}, static_cast<std::size_t>(k) % samples, amount, 0};
    for (std::size_t i = 0; i < samples; ++i) draw.z.push_back(stream.normal(i));
    draws.push_back(std::move(draw));
  }
  return draws;
}

std::vector<double> coefficients(const FoldDraw& draw, const std::vector<bool>& present) {
  std::vector<double> z;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i]) z.push_back(draw.z[i]);
  }
  // Go as far from the mean as the rung allows. Few draws are clipped, so that folds vary as the samples do; an unsound
  // fold steps down.
  const double gain = std::max(1.0, draw.amount);
  const std::vector<double> weights = clipped(principal_weights(z), {.gain = gain, .extrapolation = gain});
  double reach = draw.rung >= FoldDraw::mean_rung ? 0 : 1;
  for (int rung = 0; rung < std::min(draw.rung, FoldDraw::mean_rung); ++rung) reach *= 0.75;

  // Mix with the drawn fold, or with the mean if there is no drawn fold.
  const double share = draw.rung == FoldDraw::drawn_rung ? 0 : std::min(1.0, draw.amount);
  std::vector<double> result(present.size(), 0.0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (!present[i]) continue;
    result[i] = share * (1 / static_cast<double>(z.size()) + reach * weights[next++]);
  }
  if (present[draw.source]) {
    result[draw.source] += 1 - share;
  } else {
    for (std::size_t i = 0; i < present.size(); ++i) {
      if (present[i]) result[i] += (1 - share) / static_cast<double>(z.size());
    }
  }
  return result;
}

}  // namespace pomona
