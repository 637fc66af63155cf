#include "generator/scene/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/base/error.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/faults.h"
#include "generator/scene/settle/heap_plan.h"
#include "generator/scene/settle/height_map.h"
#include "generator/scene/settle/item_starts.h"

namespace pomona {

namespace {

double rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

Pose rounded(Pose pose) {
  const glm::dquat q = pose.rotation.w < 0 ? -pose.rotation : pose.rotation;
  pose.rotation = glm::dquat(rounded(q.w), rounded(q.x), rounded(q.y), rounded(q.z));
  for (int k = 0; k < 3; ++k) pose.translation[k] = rounded(pose.translation[k]);
  return pose;
}

/// A state of the heap that was measured.
struct Measured {
  Settled settled;
  std::vector<Fault> faults;
};

class Settling {
 public:
  Settling(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
           const SettleOptions& options)
      : plan_(solids, items, dish, options),
        draw_(plan_.draws()),
        heap_(plan_.dish(), items.size(), plan_.unit(), plan_.widest(), options.heap, options.threads),
        check_(solids, plan_.solid_numbers(), plan_.dish().mesh(), options.threads) {}

  Settled run() {
    refuse_shallow_dish(plan_);
    starts_ = item_starts(plan_);
    drop_in_waves();
    come_to_rest_without_funnel();
    Measured best;
    for (int attempt = 1; attempt <= std::max(1, options().attempts); ++attempt) {
      if (attempt > 1 && !drop_again(movable(best.faults))) break;
      lift_doubtful_pieces();
      Measured now = measured();
      now.settled.attempts = attempt;
      if (attempt == 1 || now.faults.size() <= best.faults.size()) best = std::move(now);
      if (best.faults.empty()) break;
    }
    if (!may_pass(best.faults, count(), options())) give_up(best.faults, plan_.items());
    return std::move(best.settled);
  }

 private:
  std::size_t count() const { return plan_.items().size(); }
  const SettleOptions& options() const { return plan_.options(); }

  /// A layer at a time. The last layers stay movable; what lies deeper than these is at rest for good.
  void drop_in_waves() {
    constexpr std::size_t movable_waves = 2;
    std::vector<int> orders;
    for (const SettleItem& item : plan_.items()) orders.push_back(item.order);
    std::vector<std::size_t> order = dropping_order(orders, draw_);
    heap_.set_funnel(plan_.funnel());
    HeightMap frozen = plan_.empty_map();
    std::vector<std::size_t> starts;
    std::size_t done = start_arranged(order, frozen);
    if (done > 0) starts.push_back(0);
    while (done < order.size()) {
      if (starts.size() > movable_waves) {
        const std::size_t old = starts.size() - movable_waves - 1;
        for (std::size_t i = starts[old]; i < starts[old + 1]; ++i) freeze(order[i], frozen);
      }
      HeightMap map = frozen;
      for (std::size_t i = starts.size() > movable_waves ? starts[starts.size() - movable_waves] : 0; i < done; ++i)
        raise(order[i], map);
      starts.push_back(done);
      // Who finds no room has to wait until this wave has come to rest; who then finds none has to stay out.
      const std::size_t first = done, end = std::min(order.size(), done + plan_.pieces_in_wave(order[done]));
      while (done < end && (place(order[done], 0, map) || done == first)) ++done;
      settle_heap();
    }
  }

  /// What is set, and what is let go in a place of its own, comes before all that is dropped: the first wave. Brings
  /// these to the front of the order; returns how many are let go or have found no place.
  std::size_t start_arranged(std::vector<std::size_t>& order, HeightMap& frozen) {
    const auto is_arranged = [&](std::size_t item) {
      const PieceArrangement* how = plan_.arrangement(item);
      return how && how->kind != PieceArrangementKind::heap;
    };
    const auto last = std::stable_partition(order.begin(), order.end(), is_arranged);
    if (last == order.begin()) return 0;
    for (auto item = order.begin(); item != last; ++item) {
      if (!plan_.is_set(*item) || !starts_[*item]) continue;
      heap_.put(*item, RigidBody(plan_.shape(*item), starts_[*item]->rotation, starts_[*item]->center));
      heap_.fix(*item);
      raise(*item, frozen);
    }
    for (auto item = order.begin(); item != last; ++item)
      if (!plan_.is_set(*item)) let_go(*item, 0);
    settle_heap();
    return static_cast<std::size_t>(last - order.begin());
  }

  /// From where it is to begin. When it is dropped again it is turned a little.
  void let_go(std::size_t item, std::uint64_t round) {
    if (!starts_[item]) return;
    constexpr double most_turn = 0.2;
    const std::uint64_t counter = draws_per_drop * (item + round * count());
    const double turn = round > 0 ? most_turn * (2 * draw_.uniform(counter) - 1) : 0;
    RigidBody body(plan_.shape(item), turn_about({0, 1, 0}, turn) * starts_[item]->rotation, starts_[item]->center);
    lift_clear(item, body);
    heap_.put(item, body);
  }

  void freeze(std::size_t item, HeightMap& frozen) {
    if (heap_.bodies()[item].is_fixed) return;
    if (heap_.bodies()[item].state == BodyState::out) return;
    heap_.freeze(item);
    raise(item, frozen);
  }

  void raise(std::size_t item, HeightMap& map) const {
    if (heap_.bodies()[item].state != BodyState::out) map.raise(heap_.bodies()[item]);
  }

  /// Turned as drawn, over the lowest of the places drawn, lifted until it is clear of all. False if there is no room.
  bool place(std::size_t item, std::uint64_t round, HeightMap& map) {
    const std::uint64_t counter = draws_per_drop * (item + round * count());
    glm::dvec3 up = plan_.items()[item].face_up ? plan_.shape(item).up : glm::dvec3(0);
    if (plan_.items()[item].upright) up = {0, 1, 0};
    RigidBody body(plan_.shape(item), drawn_rotation(up, draw_, counter), glm::dvec3(0));
    DropArea area = plan_.area_of(item);
    auto* const ring = std::get_if<DropRing>(&area);
    if (ring && round > 0 && plan_.in_bowl(item))
      ring->outer *= 0.7;  // away from the rim, where room is more often found
    const std::optional<glm::dvec3> at = drawn_place(body, map, area, draw_, counter + 8);
    if (!at) return false;
    body.center = *at + glm::dvec3(0, 0.05 * plan_.unit(), 0);
    body.refresh();
    lift_clear(item, body);
    map.raise(body);
    heap_.put(item, body);
    return true;
  }

  /// The map is coarse, and seen from above only.
  void lift_clear(std::size_t item, RigidBody& body) const {
    constexpr int most_lifts = 60;
    const double air = 0.02 * plan_.unit();
    for (int lift = 0; lift < most_lifts; ++lift) {
      const double clear = heap_.clearance(item, body, air);
      if (clear >= 0.99 * air) break;
      body.center.y += std::max(0.03 * plan_.unit(), air - clear);
      body.refresh();
    }
  }

  void settle_heap() {
    constexpr int between_tellings = 16;
    int step = 0;
    steps_ += heap_.settle([&] {
      if (++step % between_tellings == 0) tell_resting();
    });
    tell_resting();
  }

  void tell_resting() {
    told_ = std::max(told_, heap_.resting());
    if (options().progress) options().progress("settle", told_, count());
  }

  void come_to_rest_without_funnel() {
    heap_.set_funnel({});
    heap_.wake();
    settle_heap();
  }

  /// False if there are none.
  bool drop_again(const std::vector<std::size_t>& pieces) {
    if (pieces.empty()) return false;
    ++round_;
    again_ += pieces.size();
    for (const std::size_t item : pieces)
      if (heap_.bodies()[item].state != BodyState::out) heap_.take_out(item);
    HeightMap map = plan_.empty_map();
    for (std::size_t i = 0; i < count(); ++i) raise(i, map);
    heap_.set_funnel(plan_.funnel());
    for (const std::size_t item : pieces) {
      if (starts_[item]) {
        let_go(item, round_);
      } else {
        place(item, round_, map);
      }
    }
    settle_heap();
    heap_.set_funnel({});
    return true;
  }

  /// What the grids say lies badly is dropped again before the real meshes are asked, which takes longer.
  void lift_doubtful_pieces() {
    constexpr int most_rounds = 6;
    const double most_gap = 0.9 * options().most_gap, most_depth = 0.8 * options().most_penetration;
    for (int k = 0; k < most_rounds; ++k) {
      std::vector<std::uint8_t> is_bad(count());
      parallel_for(count(), options().threads, [&](std::size_t i) {
        const RigidBody& body = heap_.bodies()[i];
        if (plan_.is_set(i)) return;
        if (body.state == BodyState::out) {
          is_bad[i] = 1;
          return;
        }
        const double clear = heap_.clearance(i, body, 2 * most_gap * body.shape->size);
        const bool bad = clear > most_gap * body.shape->size || clear < -most_depth * body.shape->size;
        is_bad[i] = bad || plan_.is_outside(i, body.pose()) ? 1 : 0;
      });
      std::vector<std::size_t> bad;
      for (std::size_t i = 0; i < count(); ++i)
        if (is_bad[i] != 0) bad.push_back(i);
      if (bad.empty() || options().attempts <= 1) return;
      drop_again(bad);
    }
  }

  /// By the real meshes, at the poses that a file can hold.
  Measured measured() {
    Measured result;
    std::vector<std::size_t> absent;
    for (const RigidBody& body : heap_.bodies()) {
      const bool is_out = body.state == BodyState::out;
      if (is_out) absent.push_back(result.settled.poses.size());
      result.settled.poses.push_back(is_out ? Pose{} : rounded(body.pose()));
    }
    const auto tell = [&](std::size_t done) {
      if (options().progress) options().progress("measure", done, count());
    };
    result.settled.fits = check_.measure(result.settled.poses, absent, tell);
    result.settled.steps = steps_;
    result.settled.again = again_;
    for (std::size_t i = 0; i < count(); ++i) {
      std::optional<Fault> fault = fault_in(i, result.settled);
      if (fault) result.faults.push_back(std::move(*fault));
    }
    return result;
  }

  std::optional<Fault> fault_in(std::size_t item, const Settled& settled) const {
    if (heap_.bodies()[item].state == BodyState::out) return Fault{item, "finds no room in the " + plan_.dish_name()};
    if (plan_.is_outside(item, settled.poses[item])) return Fault{item, "lies outside the " + plan_.dish_name()};
    return fault_of(item, settled.fits[item], options());
  }

  /// Those that can be dropped again.
  std::vector<std::size_t> movable(const std::vector<Fault>& faults) const {
    std::vector<std::size_t> pieces;
    for (const Fault& fault : faults)
      if (!plan_.is_set(fault.piece)) pieces.push_back(fault.piece);
    return pieces;
  }

  HeapPlan plan_;
  RandomStream draw_;
  Heap heap_;
  FitCheck check_;
  std::vector<std::optional<Start>> starts_;  ///< of the items that have one
  std::uint64_t round_ = 0;                   ///< of dropping again
  int steps_ = 0;
  std::size_t again_ = 0, told_ = 0;
};

}  // namespace

Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
               const SettleOptions& options) {
  if (items.empty()) return {};
  return Settling(solids, items, dish, options).run();
}

}  // namespace pomona
