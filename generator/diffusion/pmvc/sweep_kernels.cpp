#include "generator/diffusion/pmvc/sweep_kernels.h"

#include <bit>

#include <glm/common.hpp>

// Compiles the rest of this file once per kind of processor; not for SVE, whose vectors have no size that members need.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "generator/diffusion/pmvc/sweep_kernels.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
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
using LaneMask = hn::Mask<FloatTag>;
constexpr FloatTag floats;
constexpr IntTag ints;
constexpr std::size_t group_size = TriangleGroup::size;

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

/// The bin number along one axis: a monotone function, so that a triangle's bins hold all points that it covers.
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

/// A box in the frame of the line.
struct Extents {
  Float low_u, high_u, low_v, high_v, low_w, high_w;
};

/// Bins that a box touches, both ends included.
struct BinRange {
  Int left, right, bottom, top;
};

HWY_INLINE BinRange bins_of(const Extents& box, const SweepBins& bins) {
  return {bin_along(box.low_u, bins.low_u, bins.per_u, bins.columns),
          bin_along(box.high_u, bins.low_u, bins.per_u, bins.columns),
          bin_along(box.low_v, bins.low_v, bins.per_v, bins.rows),
          bin_along(box.high_v, bins.low_v, bins.per_v, bins.rows)};
}

/// Whether a box may hold something nearer than what some point already sees.
HWY_INLINE LaneMask may_be_seen(const Extents& box, const BinRange& range, const SweepState& state) {
  // The level whose squares cover the box: the exponent of its size in cells, rounded up.
  const SweepBins& bins = state.bins;
  const SweepReach& reach = state.reach;
  const Int left = hn::ShiftRight<SweepReach::log_bins_per_cell>(range.left);
  const Int right = hn::ShiftRight<SweepReach::log_bins_per_cell>(range.right);
  const Float size = hn::ConvertTo(floats, hn::Max(hn::Sub(right, left), hn::Sub(range.top, range.bottom)));
  const Int exponent = hn::ShiftRight<23>(hn::BitCast(ints, hn::Add(size, hn::Set(floats, 0.5f))));
  const Int level = hn::Sub(exponent, hn::Set(ints, 126));

  const Int cell = hn::Add(hn::Mul(range.bottom, hn::Set(ints, reach.columns)), left);
  const Int entry = hn::Add(hn::Mul(level, hn::Set(ints, reach.cells)), cell);
  const Float nearest = hn::GatherIndex(floats, reach.nearest.data(), entry);
  const Float farthest = hn::GatherIndex(floats, reach.farthest.data(), entry);

  const LaneMask in_reach = hn::And(hn::Ge(box.high_w, nearest), hn::Le(box.low_w, farthest));
  const LaneMask beside_u =
      hn::Or(hn::Lt(box.high_u, hn::Set(floats, bins.low_u)), hn::Gt(box.low_u, hn::Set(floats, bins.high_u)));
  const LaneMask beside_v =
      hn::Or(hn::Lt(box.high_v, hn::Set(floats, bins.low_v)), hn::Gt(box.low_v, hn::Set(floats, bins.high_v)));
  return hn::AndNot(hn::Or(beside_u, beside_v), in_reach);
}

/// A mask with one bit per lane.
HWY_INLINE std::uint32_t bits_of(LaneMask mask, std::size_t lane) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(floats, mask, bytes);
  return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8) << lane;
}

/// Which of sixteen boxes may be visible.
HWY_INLINE std::uint32_t boxes_seen(const Line& line, const GroupBoxes& boxes, std::size_t first,
                                    const SweepState& state) {
  // An upper bound of the rounding error of a box.
  const Float slack = hn::Set(floats, 1e-6f);
  const auto half_along = [&](const glm::vec3& axis, std::size_t i) {
    const glm::vec3 size = glm::abs(axis);
    return hn::Add(slack, along(size, hn::Load(floats, &boxes.half[0][i]), hn::Load(floats, &boxes.half[1][i]),
                                hn::Load(floats, &boxes.half[2][i])));
  };
  std::uint32_t seen = 0;
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(floats)) {
    const std::size_t i = first + lane;
    const Point3 middle = in_frame(line, hn::Load(floats, &boxes.middle[0][i]), hn::Load(floats, &boxes.middle[1][i]),
                                   hn::Load(floats, &boxes.middle[2][i]));
    const Float u = half_along(line.across_u, i), v = half_along(line.across_v, i), w = half_along(line.along, i);
    const Extents extents{hn::Sub(middle.u, u), hn::Add(middle.u, u), hn::Sub(middle.v, v),
                          hn::Add(middle.v, v), hn::Sub(middle.w, w), hn::Add(middle.w, w)};
    seen |= bits_of(may_be_seen(extents, bins_of(extents, state.bins), state), lane);
  }
  return seen;
}

/// A function of u and v: a * u + b * v + c.
struct Plane {
  HWY_ALIGN float a[group_size], b[group_size], c[group_size];
};

/// Sixteen triangles in the frame of the line, without those that are hidden or have no area there.
struct ProjectedGroup {
  Plane edge[3];  ///< edge[k] lies opposite corner k; >= 0 inside
  HWY_ALIGN float w[3][group_size];
  HWY_ALIGN std::int32_t left[group_size], right[group_size];  ///< columns of bins
  HWY_ALIGN std::int32_t bottom[group_size], top[group_size];  ///< rows of bins
  HWY_ALIGN std::int32_t side[group_size];                     ///< as in SweepHits
  std::uint32_t seen = 0;                                      ///< a bit for each remaining triangle
};

HWY_INLINE Float min(Float a, Float b, Float c) { return hn::Min(a, hn::Min(b, c)); }
HWY_INLINE Float max(Float a, Float b, Float c) { return hn::Max(a, hn::Max(b, c)); }

HWY_INLINE Extents extents_of(const Point3& a, const Point3& b, const Point3& c) {
  const Float slack = hn::Set(floats, 1e-6f);
  return {min(a.u, b.u, c.u),
          max(a.u, b.u, c.u),
          min(a.v, b.v, c.v),
          max(a.v, b.v, c.v),
          hn::Sub(min(a.w, b.w, c.w), slack),
          hn::Add(max(a.w, b.w, c.w), slack)};
}

/// (p - q) x (r - q) across the line, as a function of q; exchanging p and r gives exactly the negative. `flip` (a sign
/// bit) negates it.
HWY_INLINE void store_edge(const Point3& p, const Point3& r, Float flip, Plane& edge, std::size_t lane) {
  hn::Store(hn::Xor(flip, hn::Sub(p.v, r.v)), floats, &edge.a[lane]);
  hn::Store(hn::Xor(flip, hn::Sub(r.u, p.u)), floats, &edge.b[lane]);
  hn::Store(hn::Xor(flip, hn::Sub(hn::Mul(p.u, r.v), hn::Mul(p.v, r.u))), floats, &edge.c[lane]);
}

HWY_INLINE Point3 corner_of(const Line& line, const TriangleGroup& group, int k, std::size_t lane) {
  return in_frame(line, hn::Load(floats, &group.corner[3 * k][lane]), hn::Load(floats, &group.corner[3 * k + 1][lane]),
                  hn::Load(floats, &group.corner[3 * k + 2][lane]));
}

HWY_INLINE void project(const Line& line, const TriangleGroup& group, const SweepState& state, ProjectedGroup& out) {
  out.seen = 0;
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(floats)) {
    const Point3 corner[3] = {corner_of(line, group, 0, lane), corner_of(line, group, 1, lane),
                              corner_of(line, group, 2, lane)};
    for (int k = 0; k < 3; ++k) hn::Store(corner[k].w, floats, &out.w[k][lane]);
    const Extents box = extents_of(corner[0], corner[1], corner[2]);
    const BinRange bins = bins_of(box, state.bins);
    hn::Store(bins.left, ints, &out.left[lane]);
    hn::Store(bins.right, ints, &out.right[lane]);
    hn::Store(bins.bottom, ints, &out.bottom[lane]);
    hn::Store(bins.top, ints, &out.top[lane]);

    // Oriented so that all edges are positive inside; edge-on triangles have no inside.
    const Float area = hn::Sub(hn::Mul(hn::Sub(corner[1].u, corner[0].u), hn::Sub(corner[2].v, corner[0].v)),
                               hn::Mul(hn::Sub(corner[1].v, corner[0].v), hn::Sub(corner[2].u, corner[0].u)));
    const Float flip = hn::And(area, hn::SignBit(floats));
    for (int k = 0; k < 3; ++k) store_edge(corner[(k + 1) % 3], corner[(k + 2) % 3], flip, out.edge[k], lane);
    const Int triangle = hn::Load(ints, &group.triangle[lane]);
    const LaneMask looks_along = hn::Gt(area, hn::Zero(floats));
    const Int front = hn::IfThenElseZero(hn::RebindMask(ints, looks_along), hn::Set(ints, 1));
    hn::Store(hn::Add(hn::Add(triangle, triangle), front), ints, &out.side[lane]);
    const LaneMask has_area = hn::Ne(area, hn::Zero(floats));
    out.seen |= bits_of(hn::And(has_area, may_be_seen(box, bins, state)), lane);
  }
}

/// Vectors of slots with some slots inside a triangle.
struct Insides {
  static constexpr std::size_t capacity = 64;
  std::size_t count = 0;
  std::size_t lane[capacity];
  std::size_t slot[capacity];
  HWY_ALIGN float edge[3][capacity][group_size];  ///< edge functions; the first is negative outside
};

HWY_INLINE Float value(const Plane& plane, std::size_t lane, Float u, Float v) {
  const Float across = hn::Add(hn::Mul(hn::Set(floats, plane.a[lane]), u), hn::Mul(hn::Set(floats, plane.b[lane]), v));
  return hn::Add(across, hn::Set(floats, plane.c[lane]));
}

/// Tests a vector of slots, of which the first `count` matter, and stores it if any is inside.
HWY_INLINE void test_slots(const ProjectedGroup& group, std::size_t lane, std::size_t slot, std::size_t count,
                           const SweepState& state, Insides& out) {
  const Float u = hn::LoadU(floats, &state.slot_u[slot]), v = hn::LoadU(floats, &state.slot_v[slot]);
  const Float e0 = value(group.edge[0], lane, u, v);
  const Float e1 = value(group.edge[1], lane, u, v);
  const Float e2 = value(group.edge[2], lane, u, v);
  const LaneMask inside = hn::And(hn::Ge(min(e0, e1, e2), hn::Zero(floats)), hn::FirstN(floats, count));
  out.lane[out.count] = lane;
  out.slot[out.count] = slot;
  hn::Store(hn::IfThenElse(inside, e0, hn::Set(floats, -1.0f)), floats, out.edge[0][out.count]);
  hn::Store(e1, floats, out.edge[1][out.count]);
  hn::Store(e2, floats, out.edge[2][out.count]);
  out.count += hn::AllFalse(floats, inside) ? 0 : 1;
}

/// Keeps a hit that is nearer than the known one, or as near with a smaller triangle index.
HWY_INLINE void keep_nearer(SweepHits& hits, std::size_t slot, LaneMask hit, Float distance, Int side, Float second,
                            Float third) {
  if (hn::AllFalse(floats, hit)) return;
  const Float best = hn::LoadU(floats, &hits.distance[slot]);
  LaneMask wins = hn::And(hit, hn::Lt(distance, best));
  const LaneMask ties = hn::And(hit, hn::Eq(distance, best));
  if (!hn::AllFalse(floats, ties)) {
    wins = hn::Or(wins, hn::And(ties, hn::RebindMask(floats, hn::Lt(side, hn::LoadU(ints, &hits.side[slot])))));
  }
  if (hn::AllFalse(floats, wins)) return;
  hn::BlendedStore(distance, wins, floats, &hits.distance[slot]);
  hn::BlendedStore(side, hn::RebindMask(ints, wins), ints, &hits.side[slot]);
  hn::BlendedStore(second, wins, floats, &hits.second[slot]);
  hn::BlendedStore(third, wins, floats, &hits.third[slot]);
}

/// The distance of the triangle from the points inside.
HWY_INLINE void keep(const ProjectedGroup& group, const Insides& insides, std::size_t i, SweepState& state) {
  const std::size_t lane = insides.lane[i], slot = insides.slot[i];
  const Float e0 = hn::Load(floats, insides.edge[0][i]);
  const Float e1 = hn::Load(floats, insides.edge[1][i]), e2 = hn::Load(floats, insides.edge[2][i]);
  const Float zero = hn::Zero(floats), sum = hn::Add(hn::Add(e0, e1), e2);
  const LaneMask inside = hn::And(hn::Ge(e0, zero), hn::Gt(sum, zero));
  const Float inverse = hn::Div(hn::Set(floats, 1.0f), sum);
  const Float second = hn::Mul(e1, inverse), third = hn::Mul(e2, inverse);
  const Float w0 = hn::Set(floats, group.w[0][lane]);
  const Float w1 = hn::Set(floats, group.w[1][lane] - group.w[0][lane]);
  const Float w2 = hn::Set(floats, group.w[2][lane] - group.w[0][lane]);
  const Float depth =
      hn::Add(hn::Add(hn::Sub(w0, hn::LoadU(floats, &state.slot_w[slot])), hn::Mul(second, w1)), hn::Mul(third, w2));
  const Int side = hn::Set(ints, group.side[lane]);
  const LaneMask is_ahead = hn::Ge(depth, zero);
  keep_nearer(state.ahead, slot, hn::And(inside, is_ahead), depth, side, second, third);
  keep_nearer(state.behind, slot, hn::AndNot(is_ahead, inside), hn::Neg(depth), side, second, third);
}

/// Tests a triangle of a group against the slots in its bins, row by row.
HWY_INLINE void cover(const ProjectedGroup& group, std::size_t lane, SweepState& state, Insides& insides) {
  const auto width = static_cast<std::int32_t>(hn::Lanes(floats));
  const SweepBins& bins = state.bins;
  const std::int32_t* first_slot = bins.first_slot.data() + group.bottom[lane] * bins.columns;
  for (std::int32_t row = group.bottom[lane]; row <= group.top[lane]; ++row, first_slot += bins.columns) {
    const std::int32_t end = first_slot[group.right[lane] + 1];
    for (std::int32_t slot = first_slot[group.left[lane]]; slot < end; slot += width) {
      test_slots(group, lane, static_cast<std::size_t>(slot), static_cast<std::size_t>(end - slot), state, insides);
      if (insides.count < Insides::capacity) continue;
      for (std::size_t k = 0; k < insides.count; ++k) keep(group, insides, k, state);
      insides.count = 0;
    }
  }
}

void Cover(const Line& line, const GroupBoxes& boxes, std::size_t first, std::size_t end,
           std::span<const TriangleGroup> groups, SweepState& state) {
  ProjectedGroup projected;
  Insides insides;
  for (std::size_t i = first; i < end; i += group_size) {
    for (std::uint32_t seen = boxes_seen(line, boxes, i, state); seen != 0; seen &= seen - 1) {
      const std::size_t box = i + static_cast<std::size_t>(std::countr_zero(seen));
      project(line, groups[boxes.group[box]], state, projected);
      for (std::uint32_t rest = projected.seen; rest != 0; rest &= rest - 1) {
        cover(projected, static_cast<std::size_t>(std::countr_zero(rest)), state, insides);
      }
      for (std::size_t k = 0; k < insides.count; ++k) keep(projected, insides, k, state);
      insides.count = 0;
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

void cover(const Line& line, const GroupBoxes& boxes, std::size_t first, std::size_t end,
           std::span<const TriangleGroup> groups, SweepState& state) {
  HWY_DYNAMIC_DISPATCH(Cover)(line, boxes, first, end, groups, state);
}

}  // namespace pomona
#endif
