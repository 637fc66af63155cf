// The wanted fineness of a cut face next to a cut segment.
#pragma once

#include "generator/cut/section/segments.h"
#include "generator/cut/section/size_field.h"
#include "generator/cut/section/split_mesh.h"

namespace pomona {

/// The source of the size field for a segment, without its position; `size` is in lengths of the segment's edges. If
/// the colours change by a quarter of `contrast` or more from edge to edge, edges next to the segment are as long as
/// its own; else they are longer.
SizeSource source_of(const CutSegment& segment, const SplitMesh& mesh, double contrast);

}  // namespace pomona
