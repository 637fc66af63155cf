// Which part of a cutting plane is section, inside which bodies, and between which cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/cut/section/face_mesh.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// How often a body's boundary winds around a place: 1 inside, 0 outside; more where it overlaps itself, negative where
/// it has turned itself inside out. All but 0 is section, so that pieces close whatever the boundary does.
struct BodyWinding {
  std::int32_t body = 0;
  int winding = 0;
  bool operator==(const BodyWinding&) const = default;
};

/// Triangles that hang together across edges that are no constraint lie in the same bodies and cells.
struct Regions {
  struct Patch {
    std::vector<BodyWinding> inside;      ///< ascending by body, no zeros
    std::array<std::uint32_t, 2> cell{};  ///< on the plane's negative and positive side
    bool section = false;                 ///< inside a body, and between two different cells

    /// On the surface of a closed knife: what else it closes, where rounding has laid layers of no thickness across.
    struct Closing {
      std::array<std::uint32_t, 2> cell{};
      std::vector<BodyWinding> inside;
    };
    std::vector<Closing> also;
  };
  std::vector<Patch> patch;
  std::vector<std::uint32_t> patch_of;  ///< per triangle

  bool is_section(std::size_t triangle) const { return patch[patch_of[triangle]].section; }
};

/// Bodies whose boundary does not close on a face, ascending, and the patches of the face, of which these bodies fill
/// those to which they turn their visible side for the greater part. Nothing of other bodies, and no cells.
struct OpenBodies {
  std::vector<std::int32_t> body;
  Regions regions;
};
OpenBodies open_bodies(const FaceMesh& face, const DiffusionSurfaces& surfaces, const Bodies& bodies);

/// The triangles of every patch, ascending.
std::vector<std::vector<std::uint32_t>> triangles_of_patches(const Regions& regions);

/// A body whose boundary does not close in this plane has no winding: it fills the regions that its boundary parts from
/// the outside and to which it turns its visible side for the greater part.
Regions find_regions(const FaceMesh& face, const CutPlanes& planes, const DiffusionSurfaces& surfaces,
                     const Bodies& bodies);

}  // namespace pomona
