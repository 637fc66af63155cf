// Where wedges begin at a variant: as far from the walls of its chambers as all of their half-planes can be.
#pragma once

#include <span>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/template/template.h"

namespace pomona {

/// The angle at which the first of so many half-planes from the axis lies, radians, at most half a wedge to either side
/// of +X. It is 0 if none of them then comes nearer than two degrees to the edge of the main chamber, that is, of the
/// loops in folds between two tissues which together are the widest; without such loops, to a fold line.
double wedge_start(const Template& variant, int count);

/// The same knives, wedges with their start. For variants: the drawing is cut as it was drawn.
std::vector<Knife> turned_wedges(std::span<const Knife> knives, const Template& variant);

}  // namespace pomona
