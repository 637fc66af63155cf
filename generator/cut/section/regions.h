// The regions of a cut face: which parts are section, in which bodies, and between which cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pomona {

/// The winding number of a body's boundary around a point: 1 inside, 0 outside; larger where the boundary overlaps
/// itself, negative where it is turned inside out. Everything except 0 is section, so that pieces are closed in every
/// case.
struct BodyWinding {
  std::int32_t body = 0;
  int winding = 0;
  bool operator==(const BodyWinding&) const = default;
};

/// A patch consists of the triangles of a face that are connected by edges without constraints. They lie in the same
/// bodies and between the same cells.
struct Regions {
  /// The parts of bodies that a patch closes, in two cells, one on either side of the patch.
  struct Closing {
    std::array<std::uint32_t, 2> cell{};  ///< on the face's negative and positive side
    std::vector<BodyWinding> inside;      ///< sorted by body, without zeros
  };
  struct Patch {
    /// Nearly always one; none if the patch is not section. More where a closed knife runs along a skin and rounding
    /// has made layers of thickness 0.
    std::vector<Closing> closes;
  };
  std::vector<Patch> patch;
  std::vector<std::uint32_t> patch_of;  ///< per triangle

  const std::vector<Closing>& closed_by(std::size_t triangle) const { return patch[patch_of[triangle]].closes; }
  bool is_section(std::size_t triangle) const { return !closed_by(triangle).empty(); }
};

}  // namespace pomona
