// The triangles of all cells, found at once by a given number of threads. A field finds them beside other work.
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
