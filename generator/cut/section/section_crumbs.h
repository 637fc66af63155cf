// Crumbs of a section: what a knife meets of a root, a seed or a leaf beside the fruit, too small to be seen as one.
#pragma once

#include "generator/cut/section/cross_section.h"

namespace pomona {

/// A component of a cut face below this share of the face's area is a crumb.
constexpr double section_crumb = 1.0 / 2000;

/// The section without its crumbs. All facets of a stroke count as one face. Triangles are connected where they have a
/// corner at the same position. Faces, names and the order of all that stays are as before; without crumbs, so is
/// everything.
CrossSection without_crumbs(CrossSection section);

}  // namespace pomona
