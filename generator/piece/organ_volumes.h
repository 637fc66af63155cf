// The volumes that organs of a fruit bound by themselves in a piece.
#pragma once

#include <cstdint>
#include <map>

#include "generator/piece/solid.h"

namespace pomona {

/// What an organ's own triangles in a piece enclose, its holes closed flat.
struct OwnVolume {
  double volume = 0, area = 0;  // cubic and square metres
  double open = 0;              // square metres of the area that close its holes

  /// Whether so little is open that it does not matter how it is closed: a stalk's end.
  bool is_exact() const { return open <= 0.05 * area; }
};

/// The volumes of all organs in a mesh, by SolidMesh::instance, but for the fruit itself.
std::map<std::int32_t, OwnVolume> organ_volumes(const SolidMesh& mesh);

}  // namespace pomona
