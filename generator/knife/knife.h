// Knives as users ask for them, before they are placed at a fruit.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/curve.h"
#include "generator/mesh/closed_surface.h"

namespace pomona {

/// The points p with dot(normal, p) = offset; the positive side is where the normal points.
struct CuttingPlane {
  glm::dvec3 normal{0, 1, 0};  ///< unit length up to rounding
  double offset = 0;           ///< metres
};

/// How many slices a fruit is cut into, or how thick they are.
struct SliceCount {
  int count = 2;  ///< 2 to max_slices
};
struct SliceThickness {
  double metres = 0;
};
using SliceSize = std::variant<SliceCount, SliceThickness>;

/// The largest number of slices, dice and sticks in one direction.
constexpr int max_slices = 1024;

struct PlaneKnife {
  CuttingPlane plane;
};
/// Along the plane z = 0.
struct HalfKnife {};
/// Along the level plane at half the height.
struct AcrossKnife {};
/// Along half-planes that begin at the axis, evenly spread.
struct WedgeKnife {
  int count = 2;
  double start = 0;  ///< angle of the first one, radians, from +X towards -Z (turned_wedges.h)
};
/// Along planes across one axis; level ones unless said otherwise.
struct SliceKnife {
  SliceSize size;
  int axis = 1;  ///< 0, 1 or 2: x, y or z
};
/// Along planes across x, y and z.
struct DiceKnife {
  SliceSize size;
};
/// Along planes across x and z.
struct StickKnife {
  SliceSize size;
};
/// Along a polyline, straight through the fruit.
struct StrokeKnife {
  std::vector<glm::dvec2> points;  ///< metres, seen along -Z; at least two, no two in a row equal
};
/// Between level waves that run along x.
struct CrinkleKnife {
  double thickness = 0;  ///< thickness of a slice, metres
};
/// Knives that cut along planes or along facets of planes (knife_planes.h).
using PlaneCut = std::variant<HalfKnife, AcrossKnife, PlaneKnife, WedgeKnife, SliceKnife, DiceKnife, StickKnife,
                              CrinkleKnife, StrokeKnife>;

/// A knife without a place or direction is placed at the front of the fruit, or upright along its axis.
struct BallKnife {
  double diameter = 0;           ///< metres
  std::optional<glm::dvec3> at;  ///< position of its middle, metres
};
struct CoreKnife {
  double diameter = 0;             ///< metres
  std::optional<double> depth;     ///< metres from the top of the fruit; right through without it
  std::optional<glm::dvec3> at;    ///< a point of its axis, metres
  std::optional<glm::dvec3> axis;  ///< unit length
};
/// A hollow with the marks of teeth.
struct BiteKnife {
  double width = 0;              ///< metres
  std::optional<glm::dvec3> at;  ///< position of its middle, metres
};
struct RevolveKnife {
  Curve profile;                   ///< x is the distance from the axis, y the height along it, metres
  std::optional<glm::dvec3> at;    ///< position of the profile's origin, metres
  std::optional<glm::dvec3> axis;  ///< unit length
};
struct PeelKnife {
  double thickness = 0;         ///< metres
  std::optional<double> strip;  ///< width of the peel if it comes off as one strip, metres; nothing = as a whole
};
struct SurfaceKnife {
  std::shared_ptr<const ClosedSurface> surface;  ///< never null
};
/// Closed knives: those that cut along a closed surface (closed_knives.h).
using ClosedCut = std::variant<BallKnife, CoreKnife, BiteKnife, RevolveKnife, PeelKnife, SurfaceKnife>;

using KnifeCut = std::variant<PlaneCut, ClosedCut>;

/// One knife as the user wrote it. Where it cuts may depend on the fruit.
struct Knife {
  KnifeCut cut = PlaneCut(HalfKnife{});
  std::string text = {};  ///< as written, for messages and metadata

  bool is_closed() const { return std::holds_alternative<ClosedCut>(cut); }
};

/// Always throws Error (usage): the knife that is written `text` is impossible, `why`, and what would do.
[[noreturn]] void refuse_knife(std::string_view text, const std::string& why, const std::string& hint);

}  // namespace pomona
