// Which part of a cut face is section, inside which bodies, and between which cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pomona {

/// How often a body's boundary winds around a place: 1 inside, 0 outside; more where it overlaps itself, negative where
/// it has turned itself inside out. All but 0 is section, so that pieces close whatever the boundary does.
struct BodyWinding {
  std::int32_t body = 0;
  int winding = 0;
  bool operator==(const BodyWinding&) const = default;
};

/// Triangles of a face that hang together across edges that are no constraint are one patch: they lie in the same
/// bodies and between the same cells.
struct Regions {
  /// What a patch closes: the parts that bodies have in two cells, one on either side of it.
  struct Closing {
    std::array<std::uint32_t, 2> cell{};  ///< on the face's negative and positive side
    std::vector<BodyWinding> inside;      ///< ascending by body, no zeros
  };
  struct Patch {
    /// Nearly always one, or none where the patch is no section. More where a closed knife runs along a skin, and
    /// rounding has laid layers of no thickness across it.
    std::vector<Closing> closes;
  };
  std::vector<Patch> patch;
  std::vector<std::uint32_t> patch_of;  ///< per triangle

  const std::vector<Closing>& closed_by(std::size_t triangle) const { return patch[patch_of[triangle]].closes; }
  bool is_section(std::size_t triangle) const { return !closed_by(triangle).empty(); }
};

}  // namespace pomona
