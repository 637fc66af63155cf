#include "generator/template/proportions.h"

#include <algorithm>

#include "generator/base/reproducible.h"

namespace pomona {

bool Proportions::are_as_drawn() const {
  return slenderness == 0 && pear == 0 && barrel == 0 && shoulders == 0 && stretch == 0;
}

double Proportions::height_factor() const { return reproducible::exp(2.0 / 3 * slenderness); }

double Proportions::place(double drawn) const {
  // Beyond the ends of the drawing, the map continues linearly.
  const double u = std::clamp(drawn, -1.0, 1.0);
  return u + stretch / 2 * (1 - u * u) + (1 - stretch * u) * (drawn - u);
}

double Proportions::radius_factor(double drawn) const {
  const double u = std::clamp(drawn, -1.0, 1.0);
  // Legendre polynomials are orthogonal, so the proportions are independent.
  const double second = 1.5 * u * u - 0.5, third = (2.5 * u * u - 1.5) * u;
  return reproducible::exp(-slenderness / 3 + pear * u - barrel * second - shoulders * third);
}

}  // namespace pomona
