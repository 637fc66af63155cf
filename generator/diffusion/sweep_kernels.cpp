#include "generator/diffusion/sweep_kernels.h"

#include <limits>

// Compiles the rest of this file once per kind of processor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generator/diffusion/sweep_kernels.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pomona::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, TriangleGroup::size>;
using IntTag = hn::RebindToSigned<FloatTag>;
using Float = hn::Vec<FloatTag>;
using Int = hn::Vec<IntTag>;
using Mask = hn::Mask<FloatTag>;
constexpr FloatTag floats;
constexpr IntTag ints;

struct Point3 {
  Float u, v, w;
};

/// A dot product in a fixed order, without fused operations.
HWY_INLINE Float along(const glm::vec3& axis, Float x, Float y, Float z) {
  const Float xy = hn::Add(hn::Mul(x, hn::Set(floats, axis.x)), hn::Mul(y, hn::Set(floats, axis.y)));
  return hn::Add(xy, hn::Mul(z, hn::Set(floats, axis.z)));
}

HWY_INLINE Point3 in_frame(const Line& line, Float x, Float y, Float z) {
  return {along(line.across_u, x, y, z), along(line.across_v, x, y, z), along(line.along, x, y, z)};
}

/// Bin number along one axis; a monotone function, so that a triangle's bins hold all the points it covers.
HWY_INLINE Int bin_along(Float place, float low, float per_length, std::int32_t count) {
  const Float bin = hn::Mul(hn::Sub(place, hn::Set(floats, low)), hn::Set(floats, per_length));
  const Float last = hn::Set(floats, static_cast<float>(count - 1));
  return hn::ConvertTo(ints, hn::Min(hn::Max(bin, hn::Zero(floats)), last));
}

void ProjectPoints(const Line& line, SweepState& state) {
  const std::size_t width = hn::Lanes(floats);
  for (std::size_t i = 0; i < state.points; i += width) {
    const Point3 p =
        in_frame(line, hn::Load(floats, &state.x[i]), hn::Load(floats, &state.y[i]), hn::Load(floats, &state.z[i]));
    hn::Store(p.u, floats, &state.u[i]);
    hn::Store(p.v, floats, &state.v[i]);
    hn::Store(p.w, floats, &state.w[i]);
  }
}

void FindBins(SweepState& state) {
  const SweepBins& bins = state.bins;
  const std::size_t width = hn::Lanes(floats);
  for (std::size_t i = 0; i < state.points; i += width) {
    const Int column = bin_along(hn::Load(floats, &state.u[i]), bins.low_u, bins.per_u, bins.columns);
    const Int row = bin_along(hn::Load(floats, &state.v[i]), bins.low_v, bins.per_v, bins.rows);
    hn::Store(hn::Add(hn::Mul(row, hn::Set(ints, bins.columns)), column), ints, &state.bin[i]);
  }
}

/// One triangle in the frame of the line.
struct Triangle {
  float u[3], v[3], w[3];
  std::int32_t id = 0;
};

/// (p x q) across the line; exactly -(q x p).
HWY_INLINE Float cross(const Point3& p, const Point3& q) { return hn::Sub(hn::Mul(p.u, q.v), hn::Mul(p.v, q.u)); }

/// Keeps a hit where it is nearer than what is known, or as near with a smaller triangle index.
HWY_INLINE void keep_nearer(SweepHits& hits, std::size_t slot, Mask hit, Float distance, Int side, Float second,
                            Float third) {
  const Float best = hn::LoadU(floats, &hits.distance[slot]);
  const Mask is_tie_won =
      hn::And(hn::Eq(distance, best), hn::RebindMask(floats, hn::Lt(side, hn::LoadU(ints, &hits.side[slot]))));
  const Mask wins = hn::And(hit, hn::Or(hn::Lt(distance, best), is_tie_won));
  if (hn::AllFalse(floats, wins)) return;
  hn::BlendedStore(distance, wins, floats, &hits.distance[slot]);
  hn::BlendedStore(side, hn::RebindMask(ints, wins), ints, &hits.side[slot]);
  hn::BlendedStore(second, wins, floats, &hits.second[slot]);
  hn::BlendedStore(third, wins, floats, &hits.third[slot]);
}

/// Tests slots [first, end) against one triangle.
HWY_INLINE void test_slots(const Triangle& triangle, std::size_t first, std::size_t end, SweepState& state) {
  const Float zero = hn::Zero(floats);
  for (std::size_t slot = first; slot < end; slot += hn::Lanes(floats)) {
    // Corners relative to the points, and the three edge functions.
    const Float u = hn::LoadU(floats, &state.slot_u[slot]);
    const Float v = hn::LoadU(floats, &state.slot_v[slot]);
    const Float w = hn::LoadU(floats, &state.slot_w[slot]);
    Point3 corner[3];
    for (int k = 0; k < 3; ++k) {
      corner[k] = {hn::Sub(hn::Set(floats, triangle.u[k]), u), hn::Sub(hn::Set(floats, triangle.v[k]), v),
                   hn::Sub(hn::Set(floats, triangle.w[k]), w)};
    }
    const Float e0 = cross(corner[1], corner[2]), e1 = cross(corner[2], corner[0]), e2 = cross(corner[0], corner[1]);

    // Inside: all of one sign, 0 included. Edge-on triangles have no inside.
    const Float sum = hn::Add(hn::Add(e0, e1), e2);
    const Mask positive = hn::Ge(hn::Min(e0, hn::Min(e1, e2)), zero);
    const Mask negative = hn::Le(hn::Max(e0, hn::Max(e1, e2)), zero);
    const Mask in_range = hn::FirstN(floats, end - slot);
    const Mask inside = hn::And(hn::And(hn::Or(positive, negative), hn::Ne(sum, zero)), in_range);
    if (hn::AllFalse(floats, inside)) continue;

    // Where, and which side.
    const Float inverse = hn::Div(hn::Set(floats, 1.0f), sum);
    const Float second = hn::Mul(e1, inverse), third = hn::Mul(e2, inverse);
    const Float depth = hn::Add(hn::Add(hn::Mul(hn::Mul(e0, inverse), corner[0].w), hn::Mul(second, corner[1].w)),
                                hn::Mul(third, corner[2].w));
    const Int id = hn::Set(ints, 2 * triangle.id);
    const Int side = hn::IfThenElse(hn::RebindMask(ints, hn::Gt(sum, zero)), hn::Add(id, hn::Set(ints, 1)), id);
    const Mask is_ahead = hn::Ge(depth, zero);
    keep_nearer(state.ahead, slot, hn::And(inside, is_ahead), depth, side, second, third);
    keep_nearer(state.behind, slot, hn::AndNot(is_ahead, inside), hn::Neg(depth), side, second, third);
  }
}

/// A group in the frame of the line, and the bins its triangles touch.
struct ProjectedGroup {
  HWY_ALIGN float u[3][TriangleGroup::size];
  HWY_ALIGN float v[3][TriangleGroup::size];
  HWY_ALIGN float w[3][TriangleGroup::size];
  HWY_ALIGN std::int32_t left[TriangleGroup::size], right[TriangleGroup::size];
  HWY_ALIGN std::int32_t bottom[TriangleGroup::size], top[TriangleGroup::size];
};

HWY_INLINE void project(const Line& line, const TriangleGroup& group, const SweepBins& bins, ProjectedGroup& out) {
  for (std::size_t lane = 0; lane < TriangleGroup::size; lane += hn::Lanes(floats)) {
    Point3 corner[3];
    for (int k = 0; k < 3; ++k) {
      corner[k] =
          in_frame(line, hn::Load(floats, &group.corner[3 * k][lane]), hn::Load(floats, &group.corner[3 * k + 1][lane]),
                   hn::Load(floats, &group.corner[3 * k + 2][lane]));
      hn::Store(corner[k].u, floats, &out.u[k][lane]);
      hn::Store(corner[k].v, floats, &out.v[k][lane]);
      hn::Store(corner[k].w, floats, &out.w[k][lane]);
    }
    const Float low_u = hn::Min(corner[0].u, hn::Min(corner[1].u, corner[2].u));
    const Float high_u = hn::Max(corner[0].u, hn::Max(corner[1].u, corner[2].u));
    const Float low_v = hn::Min(corner[0].v, hn::Min(corner[1].v, corner[2].v));
    const Float high_v = hn::Max(corner[0].v, hn::Max(corner[1].v, corner[2].v));
    hn::Store(bin_along(low_u, bins.low_u, bins.per_u, bins.columns), ints, &out.left[lane]);
    hn::Store(bin_along(high_u, bins.low_u, bins.per_u, bins.columns), ints, &out.right[lane]);
    hn::Store(bin_along(low_v, bins.low_v, bins.per_v, bins.rows), ints, &out.bottom[lane]);
    hn::Store(bin_along(high_v, bins.low_v, bins.per_v, bins.rows), ints, &out.top[lane]);
  }
}

void Cover(const Line& line, std::span<const TriangleGroup> groups, SweepState& state) {
  const SweepBins& bins = state.bins;
  ProjectedGroup projected;
  for (const TriangleGroup& group : groups) {
    project(line, group, bins, projected);
    for (int lane = 0; lane < TriangleGroup::size; ++lane) {
      Triangle triangle;
      for (int k = 0; k < 3; ++k) {
        triangle.u[k] = projected.u[k][lane];
        triangle.v[k] = projected.v[k][lane];
        triangle.w[k] = projected.w[k][lane];
      }
      triangle.id = group.triangle[lane];
      for (std::int32_t row = projected.bottom[lane]; row <= projected.top[lane]; ++row) {
        const auto first = static_cast<std::size_t>(row * bins.columns + projected.left[lane]);
        const auto last = static_cast<std::size_t>(row * bins.columns + projected.right[lane]);
        test_slots(triangle, static_cast<std::size_t>(bins.first_slot[first]),
                   static_cast<std::size_t>(bins.first_slot[last + 1]), state);
      }
    }
  }
}

}  // namespace pomona::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pomona {

HWY_EXPORT(ProjectPoints);
HWY_EXPORT(FindBins);
HWY_EXPORT(Cover);

void project_points(const Line& line, SweepState& state) { HWY_DYNAMIC_DISPATCH(ProjectPoints)(line, state); }

void find_bins(SweepState& state) { HWY_DYNAMIC_DISPATCH(FindBins)(state); }

void cover(const Line& line, std::span<const TriangleGroup> groups, SweepState& state) {
  HWY_DYNAMIC_DISPATCH(Cover)(line, groups, state);
}

}  // namespace pomona
#endif
