#include "generator/mesh/principal_axes.h"

#include <cmath>
#include <utility>

namespace pomona {

namespace {

/// Turns in the plane of the axes p and q, so that the tensor's entry at (p, q) becomes 0 [Golub and Van Loan 2013,
/// 8.5.2].
void rotate_away(glm::dmat3& tensor, glm::dmat3& axes, int p, int q) {
  if (tensor[p][q] == 0) return;
  const double ratio = (tensor[q][q] - tensor[p][p]) / (2 * tensor[p][q]);
  const double tangent = (ratio < 0 ? -1.0 : 1.0) / (std::abs(ratio) + std::sqrt(1 + ratio * ratio));
  const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
  glm::dmat3 turn(1);
  turn[p][p] = turn[q][q] = cosine;
  turn[q][p] = sine;
  turn[p][q] = -sine;
  tensor = glm::transpose(turn) * tensor * turn;
  tensor[p][q] = tensor[q][p] = 0;
  axes = axes * turn;
}

}  // namespace

PrincipalAxes principal_axes(const glm::dmat3& tensor) {
  glm::dmat3 left = tensor, axes(1);
  // It converges quadratically: a few sweeps are enough for every digit.
  for (int sweep = 0; sweep < 10; ++sweep)
    for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) rotate_away(left, axes, p, q);
  return {{left[0][0], left[1][1], left[2][2]}, glm::normalize(glm::quat_cast(axes))};
}

}  // namespace pomona
