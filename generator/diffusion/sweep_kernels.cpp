#include "generator/diffusion/sweep_kernels.h"

#include <bit>

#include <glm/common.hpp>

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

/// A box in the frame of the line.
struct Extents {
  Float low_u, high_u, low_v, high_v, low_w, high_w;
};

/// Whether a box may hold something nearer than what some point sees already.
HWY_INLINE Mask may_be_seen(const Extents& box, const SweepState& state) {
  // The level whose squares are no smaller than the box, from the exponent of its size in bins.
  const SweepBins& bins = state.bins;
  const SweepReach& reach = state.reach;
  const Float size = hn::Max(hn::Mul(hn::Sub(box.high_u, box.low_u), hn::Set(floats, bins.per_u)),
                             hn::Mul(hn::Sub(box.high_v, box.low_v), hn::Set(floats, bins.per_v)));
  const Int exponent = hn::Sub(hn::ShiftRight<23>(hn::BitCast(ints, size)), hn::Set(ints, 126));
  const Int level = hn::Min(hn::Max(exponent, hn::Zero(ints)), hn::Set(ints, reach.levels - 1));

  // Its square there.
  const Int column = hn::Shr(bin_along(box.low_u, bins.low_u, bins.per_u, bins.columns), level);
  const Int row = hn::Shr(bin_along(box.low_v, bins.low_v, bins.per_v, bins.rows), level);
  const Int first = hn::GatherIndex(ints, reach.first.data(), level);
  const Int columns = hn::GatherIndex(ints, reach.columns.data(), level);
  const Int entry = hn::Add(first, hn::Add(hn::Mul(row, columns), column));
  const Float nearest = hn::GatherIndex(floats, reach.nearest.data(), entry);
  const Float farthest = hn::GatherIndex(floats, reach.farthest.data(), entry);

  const Mask in_reach = hn::And(hn::Ge(box.high_w, nearest), hn::Le(box.low_w, farthest));
  const Mask beside_u =
      hn::Or(hn::Lt(box.high_u, hn::Set(floats, bins.low_u)), hn::Gt(box.low_u, hn::Set(floats, bins.high_u)));
  const Mask beside_v =
      hn::Or(hn::Lt(box.high_v, hn::Set(floats, bins.low_v)), hn::Gt(box.low_v, hn::Set(floats, bins.high_v)));
  return hn::AndNot(hn::Or(beside_u, beside_v), in_reach);
}

/// One bit a lane.
HWY_INLINE std::uint32_t bits_of(Mask mask, std::size_t lane) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(floats, mask, bytes);
  return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8) << lane;
}

/// Which of sixteen boxes may be seen.
HWY_INLINE std::uint32_t boxes_seen(const Line& line, const GroupBoxes& boxes, std::size_t first,
                                    const SweepState& state) {
  // What rounding may take from a box.
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
    seen |= bits_of(may_be_seen(extents, state), lane);
  }
  return seen;
}

/// A group in the frame of the line, and the bins its triangles touch.
struct ProjectedGroup {
  HWY_ALIGN float u[3][group_size];
  HWY_ALIGN float v[3][group_size];
  HWY_ALIGN float w[3][group_size];
  HWY_ALIGN std::int32_t left[group_size], right[group_size];
  HWY_ALIGN std::int32_t bottom[group_size], top[group_size];  ///< bottom > top for those that cannot be seen
  HWY_ALIGN std::int32_t side[group_size];                     ///< 2 * triangle
  std::int32_t most_rows = 0;
};

HWY_INLINE Float least(Float a, Float b, Float c) { return hn::Min(a, hn::Min(b, c)); }
HWY_INLINE Float most(Float a, Float b, Float c) { return hn::Max(a, hn::Max(b, c)); }

HWY_INLINE void project(const Line& line, const TriangleGroup& group, const SweepState& state, ProjectedGroup& out) {
  const SweepBins& bins = state.bins;
  const Float slack = hn::Set(floats, 1e-6f);
  Int most_rows = hn::Set(ints, -1);
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(floats)) {
    Point3 corner[3];
    for (int k = 0; k < 3; ++k) {
      corner[k] =
          in_frame(line, hn::Load(floats, &group.corner[3 * k][lane]), hn::Load(floats, &group.corner[3 * k + 1][lane]),
                   hn::Load(floats, &group.corner[3 * k + 2][lane]));
      hn::Store(corner[k].u, floats, &out.u[k][lane]);
      hn::Store(corner[k].v, floats, &out.v[k][lane]);
      hn::Store(corner[k].w, floats, &out.w[k][lane]);
    }
    const Extents box{least(corner[0].u, corner[1].u, corner[2].u),
                      most(corner[0].u, corner[1].u, corner[2].u),
                      least(corner[0].v, corner[1].v, corner[2].v),
                      most(corner[0].v, corner[1].v, corner[2].v),
                      hn::Sub(least(corner[0].w, corner[1].w, corner[2].w), slack),
                      hn::Add(most(corner[0].w, corner[1].w, corner[2].w), slack)};
    const auto seen = hn::RebindMask(ints, may_be_seen(box, state));
    const Int bottom = bin_along(box.low_v, bins.low_v, bins.per_v, bins.rows);
    const Int top = hn::IfThenElse(seen, bin_along(box.high_v, bins.low_v, bins.per_v, bins.rows), hn::Set(ints, -1));
    hn::Store(bin_along(box.low_u, bins.low_u, bins.per_u, bins.columns), ints, &out.left[lane]);
    hn::Store(bin_along(box.high_u, bins.low_u, bins.per_u, bins.columns), ints, &out.right[lane]);
    hn::Store(bottom, ints, &out.bottom[lane]);
    hn::Store(top, ints, &out.top[lane]);
    most_rows = hn::Max(most_rows, hn::Sub(top, bottom));
    const Int triangle = hn::Load(ints, &group.triangle[lane]);
    hn::Store(hn::Add(triangle, triangle), ints, &out.side[lane]);
  }
  out.most_rows = 1 + hn::GetLane(hn::MaxOfLanes(ints, most_rows));
}

/// Triangles of a group and ranges of slots in one of their rows of bins.
struct Candidates {
  std::size_t count = 0;
  HWY_ALIGN std::int32_t lane[2 * group_size];
  HWY_ALIGN std::int32_t first[2 * group_size];
  HWY_ALIGN std::int32_t end[2 * group_size];
};

/// Lists the triangles that have a row number `step` and any point in their bins there.
HWY_INLINE void list_row(const ProjectedGroup& group, std::int32_t step, const SweepBins& bins, Candidates& out) {
  out.count = 0;
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(floats)) {
    const Int row = hn::Add(hn::Load(ints, &group.bottom[lane]), hn::Set(ints, step));
    const auto exists = hn::Not(hn::Gt(row, hn::Load(ints, &group.top[lane])));
    const Int start = hn::Mul(row, hn::Set(ints, bins.columns));
    const Int from = hn::IfThenElseZero(exists, hn::Add(start, hn::Load(ints, &group.left[lane])));
    const Int to = hn::IfThenElseZero(exists, hn::Add(start, hn::Load(ints, &group.right[lane])));
    const Int first = hn::GatherIndex(ints, bins.first_slot.data(), from);
    const Int end = hn::GatherIndex(ints, bins.first_slot.data() + 1, to);
    const auto any = hn::And(exists, hn::Lt(first, end));
    hn::CompressBlendedStore(hn::Iota(ints, static_cast<std::int32_t>(lane)), any, ints, &out.lane[out.count]);
    hn::CompressBlendedStore(first, any, ints, &out.first[out.count]);
    out.count += hn::CompressBlendedStore(end, any, ints, &out.end[out.count]);
  }
}

/// Vectors of slots of which some lie inside a triangle.
struct Insides {
  static constexpr std::size_t capacity = 64;
  std::size_t count = 0;
  std::int32_t lane[capacity];
  std::size_t slot[capacity];
  HWY_ALIGN float second[capacity][group_size];  ///< edge functions
  HWY_ALIGN float third[capacity][group_size];
  HWY_ALIGN float sum[capacity][group_size];  ///< 0 outside
};

/// (p x q) across the line; exactly -(q x p).
HWY_INLINE Float cross(Float pu, Float pv, Float qu, Float qv) { return hn::Sub(hn::Mul(pu, qv), hn::Mul(pv, qu)); }

/// Tests a vector of slots of which the first `count` matter, and notes it if any is inside.
HWY_INLINE void test_slots(const ProjectedGroup& group, std::int32_t lane, std::size_t slot, std::size_t count,
                           const SweepState& state, Insides& out) {
  // Corners relative to the points, and the three edge functions.
  const Float u = hn::LoadU(floats, &state.slot_u[slot]), v = hn::LoadU(floats, &state.slot_v[slot]);
  const Float u0 = hn::Sub(hn::Set(floats, group.u[0][lane]), u), v0 = hn::Sub(hn::Set(floats, group.v[0][lane]), v);
  const Float u1 = hn::Sub(hn::Set(floats, group.u[1][lane]), u), v1 = hn::Sub(hn::Set(floats, group.v[1][lane]), v);
  const Float u2 = hn::Sub(hn::Set(floats, group.u[2][lane]), u), v2 = hn::Sub(hn::Set(floats, group.v[2][lane]), v);
  const Float e0 = cross(u1, v1, u2, v2), e1 = cross(u2, v2, u0, v0), e2 = cross(u0, v0, u1, v1);

  // Inside: all of one sign, 0 included. Edge-on triangles have no inside: their sum is 0.
  const Float zero = hn::Zero(floats);
  const Mask one_sign = hn::Or(hn::Ge(least(e0, e1, e2), zero), hn::Le(most(e0, e1, e2), zero));
  const Mask inside = hn::And(one_sign, hn::FirstN(floats, count));
  const Float sum = hn::IfThenElseZero(inside, hn::Add(hn::Add(e0, e1), e2));
  out.lane[out.count] = lane;
  out.slot[out.count] = slot;
  hn::Store(e1, floats, out.second[out.count]);
  hn::Store(e2, floats, out.third[out.count]);
  hn::Store(sum, floats, out.sum[out.count]);
  out.count += hn::AllFalse(floats, hn::Ne(sum, zero)) ? 0 : 1;
}

/// Keeps a hit where it is nearer than what is known, or as near with a smaller triangle index.
HWY_INLINE void keep_nearer(SweepHits& hits, std::size_t slot, Mask hit, Float distance, Int side, Float second,
                            Float third) {
  const Float best = hn::LoadU(floats, &hits.distance[slot]);
  Mask wins = hn::And(hit, hn::Lt(distance, best));
  const Mask ties = hn::And(hit, hn::Eq(distance, best));
  if (!hn::AllFalse(floats, ties)) {
    wins = hn::Or(wins, hn::And(ties, hn::RebindMask(floats, hn::Lt(side, hn::LoadU(ints, &hits.side[slot])))));
  }
  if (hn::AllFalse(floats, wins)) return;
  hn::BlendedStore(distance, wins, floats, &hits.distance[slot]);
  hn::BlendedStore(side, hn::RebindMask(ints, wins), ints, &hits.side[slot]);
  hn::BlendedStore(second, wins, floats, &hits.second[slot]);
  hn::BlendedStore(third, wins, floats, &hits.third[slot]);
}

/// How far the triangle is from the points inside, and which side it shows.
HWY_INLINE void keep(const ProjectedGroup& group, const Insides& insides, std::size_t i, SweepState& state) {
  const std::int32_t lane = insides.lane[i];
  const std::size_t slot = insides.slot[i];
  const Float zero = hn::Zero(floats), sum = hn::Load(floats, insides.sum[i]);
  const Float inverse = hn::Div(hn::Set(floats, 1.0f), sum);
  const Float second = hn::Mul(hn::Load(floats, insides.second[i]), inverse);
  const Float third = hn::Mul(hn::Load(floats, insides.third[i]), inverse);
  const Float w0 = hn::Set(floats, group.w[0][lane]);
  const Float w1 = hn::Set(floats, group.w[1][lane] - group.w[0][lane]);
  const Float w2 = hn::Set(floats, group.w[2][lane] - group.w[0][lane]);
  const Float depth =
      hn::Add(hn::Add(hn::Sub(w0, hn::LoadU(floats, &state.slot_w[slot])), hn::Mul(second, w1)), hn::Mul(third, w2));
  const Int id = hn::Set(ints, group.side[lane]);
  const Int side = hn::IfThenElse(hn::RebindMask(ints, hn::Gt(sum, zero)), hn::Add(id, hn::Set(ints, 1)), id);
  const Mask inside = hn::Ne(sum, zero), is_ahead = hn::Ge(depth, zero);
  keep_nearer(state.ahead, slot, hn::And(inside, is_ahead), depth, side, second, third);
  keep_nearer(state.behind, slot, hn::AndNot(is_ahead, inside), hn::Neg(depth), side, second, third);
}

/// Tests all triangles of a group against the slots in their bins.
HWY_INLINE void cover(const ProjectedGroup& group, SweepState& state, Candidates& candidates, Insides& insides) {
  const auto width = static_cast<std::int32_t>(hn::Lanes(floats));
  for (std::int32_t step = 0; step < group.most_rows; ++step) {
    list_row(group, step, state.bins, candidates);
    for (std::size_t i = 0; i < candidates.count; ++i) {
      const std::int32_t end = candidates.end[i];
      for (std::int32_t slot = candidates.first[i]; slot < end; slot += width) {
        test_slots(group, candidates.lane[i], static_cast<std::size_t>(slot), static_cast<std::size_t>(end - slot),
                   state, insides);
        if (insides.count < Insides::capacity) continue;
        for (std::size_t k = 0; k < insides.count; ++k) keep(group, insides, k, state);
        insides.count = 0;
      }
    }
  }
  for (std::size_t k = 0; k < insides.count; ++k) keep(group, insides, k, state);
  insides.count = 0;
}

void Cover(const Line& line, const GroupBoxes& boxes, std::size_t first, std::size_t end,
           std::span<const TriangleGroup> groups, SweepState& state) {
  ProjectedGroup projected;
  Candidates candidates;
  Insides insides;
  for (std::size_t i = first; i < end; i += group_size) {
    for (std::uint32_t seen = boxes_seen(line, boxes, i, state); seen != 0; seen &= seen - 1) {
      const std::size_t box = i + static_cast<std::size_t>(std::countr_zero(seen));
      project(line, groups[boxes.group[box]], state, projected);
      cover(projected, state, candidates, insides);
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
