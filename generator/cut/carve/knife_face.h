// The surface of a closed knife as a face of the section.
#pragma once

#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/cut/carve/closed_knife.h"
#include "generator/cut/carve/split_surfaces.h"
#include "generator/cut/section/face.h"

namespace pomona {

/// The knife's triangles, as split in the arrangement. Facets are the knife's smooth faces, still without frames
/// (knife_charts.h). Points of the arrangement must be points of `mesh`.
Face knife_face(const Arrangement& all, const ClosedKnife& knife, const KnifeTraces& traces, const SplitMesh& mesh);

}  // namespace pomona
