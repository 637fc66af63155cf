// How fine a cut face should be next to a cut segment.
#pragma once

#include "generator/cut/section/segments.h"
#include "generator/cut/section/size_field.h"
#include "generator/cut/section/split_mesh.h"

namespace pomona {

/// What the size field is to know of a segment but for its place; `size` counts in edges' lengths. Colours that change
/// by a quarter of `contrast` or more from edge to edge want edges as long as their own next to them, others longer
/// ones.
SizeSource source_of(const CutSegment& segment, const SplitMesh& mesh, double contrast);

}  // namespace pomona
