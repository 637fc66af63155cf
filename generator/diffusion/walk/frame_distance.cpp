#include "generator/diffusion/walk/frame_distance.h"

#include <algorithm>
#include <limits>

// Compiles the rest of this file once per kind of processor; not for SVE, whose vectors have no size that members need.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generator/diffusion/walk/frame_distance.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pomona::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FrameTag = hn::CappedTag<float, FrameGroup::size>;
using Lanes = hn::Vec<FrameTag>;
constexpr FrameTag lanes;

/// A sum in a fixed order, without fused operations.
HWY_INLINE Lanes in_direction(const float (&axis)[3][FrameGroup::size], std::size_t i, Lanes x, Lanes y, Lanes z) {
  const Lanes xy = hn::Add(hn::Mul(x, hn::Load(lanes, &axis[0][i])), hn::Mul(y, hn::Load(lanes, &axis[1][i])));
  return hn::Add(xy, hn::Mul(z, hn::Load(lanes, &axis[2][i])));
}

HWY_INLINE Lanes squared(Lanes a, Lanes b) { return hn::Add(hn::Mul(a, a), hn::Mul(b, b)); }

/// Squared distance from (u, v) to the segment from 0 to (eu, ev).
HWY_INLINE Lanes to_segment(Lanes u, Lanes v, Lanes eu, Lanes ev, Lanes per_length) {
  const Lanes along = hn::Mul(hn::Add(hn::Mul(u, eu), hn::Mul(v, ev)), per_length);
  const Lanes t = hn::Min(hn::Max(along, hn::Zero(lanes)), hn::Set(lanes, 1.0f));
  return squared(hn::Sub(u, hn::Mul(t, eu)), hn::Sub(v, hn::Mul(t, ev)));
}

/// Squared distances to the triangles from lane i on.
HWY_INLINE Lanes squared_distance(const FrameGroup& group, std::size_t i, const glm::vec3& point) {
  // Transforms the point into the triangles' frames.
  const Lanes x = hn::Sub(hn::Set(lanes, point.x), hn::Load(lanes, &group.origin[0][i]));
  const Lanes y = hn::Sub(hn::Set(lanes, point.y), hn::Load(lanes, &group.origin[1][i]));
  const Lanes z = hn::Sub(hn::Set(lanes, point.z), hn::Load(lanes, &group.origin[2][i]));
  const Lanes u = in_direction(group.u, i, x, y, z), v = in_direction(group.v, i, x, y, z);
  const Lanes w = in_direction(group.w, i, x, y, z);

  // The distances to the three edges.
  const Lanes length = hn::Load(lanes, &group.length[i]), zero = hn::Zero(lanes);
  const Lanes eu = hn::Load(lanes, &group.apex_u[i]), ev = hn::Load(lanes, &group.apex_v[i]);
  const Lanes on_base = squared(hn::Sub(u, hn::Min(hn::Max(u, zero), length)), v);
  const Lanes left = to_segment(u, v, eu, ev, hn::Load(lanes, &group.per_left[i]));
  const Lanes ru = hn::Sub(u, length), reu = hn::Sub(eu, length);
  const Lanes right = to_segment(ru, v, reu, ev, hn::Load(lanes, &group.per_right[i]));

  // Within the triangle, the distance in the plane does not count.
  const auto inside = hn::And(
      hn::Ge(v, zero), hn::And(hn::Ge(hn::Mul(ev, u), hn::Mul(eu, v)), hn::Ge(hn::Mul(reu, v), hn::Mul(ev, ru))));
  const Lanes beside = hn::IfThenZeroElse(inside, hn::Min(on_base, hn::Min(left, right)));
  return hn::Add(beside, hn::Mul(w, w));
}

void SquaredDistances(const FrameGroup& group, const glm::vec3& point, float* squared_out) {
  for (std::size_t i = 0; i < FrameGroup::size; i += hn::Lanes(lanes)) {
    hn::StoreU(squared_distance(group, i, point), lanes, squared_out + i);
  }
}

float MinSquaredDistance(const FrameGroup* groups, const NearGroup* near, std::size_t count, float reach,
                         const glm::vec3& point) {
  float min = std::numeric_limits<float>::max();
  for (std::size_t n = 0; n < count; ++n) {
    const float beyond = near[n].distance - reach;
    if (beyond > 0 && beyond * beyond > min) break;
    const FrameGroup& group = groups[near[n].group];
    for (std::size_t i = 0; i < FrameGroup::size; i += hn::Lanes(lanes)) {
      min = std::min(min, hn::GetLane(hn::MinOfLanes(lanes, squared_distance(group, i, point))));
    }
  }
  return min;
}

}  // namespace pomona::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pomona {

HWY_EXPORT(SquaredDistances);
HWY_EXPORT(MinSquaredDistance);

GroupDistances squared_distances(const FrameGroup& group, const glm::vec3& point) {
  GroupDistances distances;
  HWY_DYNAMIC_DISPATCH(SquaredDistances)(group, point, distances.data());
  return distances;
}

float min_squared_distance(const FrameGroup* groups, const NearGroup* near, std::size_t count, float reach,
                           const glm::vec3& point) {
  return HWY_DYNAMIC_DISPATCH(MinSquaredDistance)(groups, near, count, reach, point);
}

}  // namespace pomona
#endif  // HWY_ONCE
