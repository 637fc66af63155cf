// All cells' triangles at once, by as many threads as wanted: what a field finds beside other work.
#pragma once

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/cell_triangles.h"

namespace pomona {

inline CellTriangles cell_triangles(const SnappedSurfaces& snapped, const Lattice& lattice, double margin,
                                    Threads threads) {
  CellTriangleFinder finder(snapped, lattice, margin);
  parallel_for(finder.slab_count(), threads, [&](std::size_t i) { finder.find(i); });
  finder.place();
  parallel_for(finder.slab_count(), threads, [&](std::size_t i) { finder.fill(i); });
  return finder.taken();
}

}  // namespace pomona
