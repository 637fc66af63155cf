// Reasons why a drawn curve cannot be swept, as messages for the person who drew it.
#pragma once

#include <optional>
#include <string>

#include "generator/template/template.h"

namespace pomona {

/// "crosses itself", and what to redraw.
struct CurveFault {
  std::string message;
  std::string hint;
};

/// A vertical curve: not left of the axis, simple; around the axis it may touch the axis only with its ends, in a
/// fold it is a closed loop off the axis.
std::optional<CurveFault> fault_of_vertical(const Curve& curve, SurfaceType type);

/// A vertical curve of a surface around the axis that separates fruit from air: its ends lie on the axis, or it is
/// closed.
std::optional<CurveFault> fault_of_open_ends(const Curve& curve);

/// A horizontal curve around the axis: closed, simple, surrounds the axis, and crosses each fold line once.
std::optional<CurveFault> fault_of_loop_around_axis(const Curve& loop, const Symmetry& symmetry);

/// A horizontal curve in fold k: closed, simple, between its two fold lines.
std::optional<CurveFault> fault_of_loop_in_fold(const Curve& loop, const FoldSymmetry& folds, std::size_t k);

}  // namespace pomona
