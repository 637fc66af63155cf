#include "generator/template/axis_bend.h"

namespace pomona {

// The first and the second Legendre polynomial: their mean is 0.
double AxisBend::lean(double place) const { return angle / 2 * place + swing / 3 * (1.5 * place * place - 0.5); }

double AxisBend::turning(double place) const { return angle / 2 + swing * place; }

}  // namespace pomona
