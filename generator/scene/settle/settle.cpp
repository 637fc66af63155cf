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

/// A state of the heap, measured on the meshes.
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
        world_(plan_.dish(), items.size(), plan_.unit(), plan_.widest(), options.world, options.threads),
        check_(solids, plan_.solid_numbers(), plan_.dish().mesh(), options.threads) {}

  Settled run() {
    refuse_shallow_dish(plan_);
    starts_ = item_starts(plan_);
    drop_in_waves();
    come_to_rest_without_funnel();
    Measured best;
    for (int attempt = 1; attempt <= std::max(1, options().attempts); ++attempt) {
      if (attempt > 1 && !drop_again(movable(best.faults))) break;
      drop_doubtful_pieces_again();
      Measured now = measured();
      now.settled.attempts = attempt;
      if (attempt == 1 || now.faults.size() <= best.faults.size()) best = std::move(now);
      if (best.faults.empty()) break;
    }
    if (!are_acceptable(best.faults, count(), options())) give_up(best.faults, plan_.items());
    return std::move(best.settled);
  }

 private:
  std::size_t count() const { return plan_.items().size(); }
  const SettleOptions& options() const { return plan_.options(); }

  /// Drops one layer of pieces at a time. The last layers stay movable; deeper layers are frozen.
  void drop_in_waves() {
    constexpr std::size_t movable_waves = 2;
    std::vector<int> orders;
    for (const SettleItem& item : plan_.items()) orders.push_back(item.order);
    std::vector<std::size_t> order = dropping_order(orders, draw_);
    world_.set_funnel(plan_.funnel());
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
      // A piece that finds no room waits until this wave is at rest. If there is no room then, it stays absent.
      const std::size_t first = done, end = std::min(order.size(), done + plan_.pieces_in_wave(order[done]));
      while (done < end && (place(order[done], 0, map) || done == first)) ++done;
      run_world();
    }
  }

  /// The first wave: the arranged items, before all that are dropped at random. Moves them to the front of the order;
  /// returns their number.
  std::size_t start_arranged(std::vector<std::size_t>& order, HeightMap& frozen) {
    const auto is_arranged = [&](std::size_t item) {
      const PieceArrangement* how = plan_.arrangement(item);
      return how && how->kind != PieceArrangementKind::heap;
    };
    const auto last = std::stable_partition(order.begin(), order.end(), is_arranged);
    if (last == order.begin()) return 0;
    for (auto item = order.begin(); item != last; ++item) {
      if (!plan_.is_placed(*item) || !starts_[*item]) continue;
      world_.put(*item, RigidBody(plan_.shape(*item), starts_[*item]->rotation, starts_[*item]->center));
      world_.fix(*item);
      raise(*item, frozen);
    }
    for (auto item = order.begin(); item != last; ++item)
      if (!plan_.is_placed(*item)) release(*item, 0);
    run_world();
    return static_cast<std::size_t>(last - order.begin());
  }

  /// Drops an item from its start pose. When it is dropped again it is first turned a little.
  void release(std::size_t item, std::uint64_t round) {
    if (!starts_[item]) return;
    constexpr double max_turn = 0.2;
    const std::uint64_t counter = draws_per_drop * (item + round * count());
    const double turn = round > 0 ? max_turn * (2 * draw_.uniform(counter) - 1) : 0;
    RigidBody body(plan_.shape(item), turn_about({0, 1, 0}, turn) * starts_[item]->rotation, starts_[item]->center);
    lift_clear(item, body);
    world_.put(item, body);
  }

  void freeze(std::size_t item, HeightMap& frozen) {
    if (world_.bodies()[item].is_fixed) return;
    if (world_.bodies()[item].state == BodyState::absent) return;
    world_.freeze(item);
    raise(item, frozen);
  }

  void raise(std::size_t item, HeightMap& map) const {
    if (world_.bodies()[item].state != BodyState::absent) map.raise(world_.bodies()[item]);
  }

  /// Puts an item into the world: in a random rotation, above the lowest of some random places, lifted until it touches
  /// nothing. Returns false if there is no room.
  bool place(std::size_t item, std::uint64_t round, HeightMap& map) {
    const std::uint64_t counter = draws_per_drop * (item + round * count());
    glm::dvec3 up = plan_.items()[item].face_up ? plan_.shape(item).up : glm::dvec3(0);
    if (plan_.items()[item].upright) up = {0, 1, 0};
    RigidBody body(plan_.shape(item), random_rotation(up, draw_, counter), glm::dvec3(0));
    DropArea area = plan_.area_of(item);
    auto* const ring = std::get_if<DropRing>(&area);
    if (ring && round > 0 && plan_.in_bowl(item))
      ring->outer *= 0.7;  // away from the rim, where room is more often found
    const std::optional<glm::dvec3> at = random_place(body, map, area, draw_, counter + 8);
    if (!at) return false;
    body.center = *at + glm::dvec3(0, 0.05 * plan_.unit(), 0);
    body.refresh();
    lift_clear(item, body);
    map.raise(body);
    world_.put(item, body);
    return true;
  }

  /// Lifts a body until it touches nothing. The height map alone is too coarse for that.
  void lift_clear(std::size_t item, RigidBody& body) const {
    constexpr int max_lifts = 60;
    const double air = 0.02 * plan_.unit();
    for (int lift = 0; lift < max_lifts; ++lift) {
      const double clear = world_.clearance(item, body, air);
      if (clear >= 0.99 * air) break;
      body.center.y += std::max(0.03 * plan_.unit(), air - clear);
      body.refresh();
    }
  }

  void run_world() {
    constexpr int steps_per_report = 16;
    int step = 0;
    steps_ += world_.run_until_rest([&] {
      if (++step % steps_per_report == 0) report_resting();
    });
    report_resting();
  }

  void report_resting() {
    reported_ = std::max(reported_, world_.resting_count());
    if (options().progress) options().progress("settle", reported_, count());
  }

  void come_to_rest_without_funnel() {
    world_.set_funnel({});
    world_.wake_all();
    run_world();
  }

  /// Removes pieces and drops them once more. Returns false if there are none.
  bool drop_again(const std::vector<std::size_t>& pieces) {
    if (pieces.empty()) return false;
    ++round_;
    again_ += pieces.size();
    for (const std::size_t item : pieces)
      if (world_.bodies()[item].state != BodyState::absent) world_.remove(item);
    HeightMap map = plan_.empty_map();
    for (std::size_t i = 0; i < count(); ++i) raise(i, map);
    world_.set_funnel(plan_.funnel());
    for (const std::size_t item : pieces) {
      if (starts_[item]) {
        release(item, round_);
      } else {
        place(item, round_, map);
      }
    }
    run_world();
    world_.set_funnel({});
    return true;
  }

  /// Drops again the pieces that lie badly by the distance grids. Measuring the meshes comes later: it takes longer.
  void drop_doubtful_pieces_again() {
    constexpr int max_rounds = 6;
    const double max_gap = 0.9 * options().max_gap, max_depth = 0.8 * options().max_penetration;
    for (int k = 0; k < max_rounds; ++k) {
      std::vector<std::uint8_t> is_bad(count());
      parallel_for(count(), options().threads, [&](std::size_t i) {
        const RigidBody& body = world_.bodies()[i];
        if (plan_.is_placed(i)) return;
        if (body.state == BodyState::absent) {
          is_bad[i] = 1;
          return;
        }
        const double clear = world_.clearance(i, body, 2 * max_gap * body.shape->size);
        const bool bad = clear > max_gap * body.shape->size || clear < -max_depth * body.shape->size;
        is_bad[i] = bad || plan_.is_outside(i, body.pose()) ? 1 : 0;
      });
      std::vector<std::size_t> bad;
      for (std::size_t i = 0; i < count(); ++i)
        if (is_bad[i] != 0) bad.push_back(i);
      if (bad.empty() || options().attempts <= 1) return;
      drop_again(bad);
    }
  }

  /// Measures the meshes, at the rounded poses that a file holds.
  Measured measured() {
    Measured result;
    std::vector<std::size_t> absent;
    for (const RigidBody& body : world_.bodies()) {
      const bool is_out = body.state == BodyState::absent;
      if (is_out) absent.push_back(result.settled.poses.size());
      result.settled.poses.push_back(is_out ? Pose{} : rounded(body.pose()));
    }
    const auto report = [&](std::size_t done) {
      if (options().progress) options().progress("measure", done, count());
    };
    result.settled.fits = check_.measure(result.settled.poses, absent, report);
    result.settled.steps = steps_;
    result.settled.again = again_;
    for (std::size_t i = 0; i < count(); ++i) {
      std::optional<Fault> fault = fault_in(i, result.settled);
      if (fault) result.faults.push_back(std::move(*fault));
    }
    return result;
  }

  std::optional<Fault> fault_in(std::size_t item, const Settled& settled) const {
    if (world_.bodies()[item].state == BodyState::absent)
      return Fault{item, "finds no room in the " + plan_.dish_name()};
    if (plan_.is_outside(item, settled.poses[item])) return Fault{item, "lies outside the " + plan_.dish_name()};
    return fault_of(item, settled.fits[item], options());
  }

  /// The pieces with faults that can be dropped again.
  std::vector<std::size_t> movable(const std::vector<Fault>& faults) const {
    std::vector<std::size_t> pieces;
    for (const Fault& fault : faults)
      if (!plan_.is_placed(fault.piece)) pieces.push_back(fault.piece);
    return pieces;
  }

  HeapPlan plan_;
  RandomStream draw_;
  RigidBodyWorld world_;
  FitCheck check_;
  std::vector<std::optional<StartPose>> starts_;  ///< one per item; nothing for items that are dropped at random
  std::uint64_t round_ = 0;                       ///< number of times that pieces were dropped again
  int steps_ = 0;                                 ///< number of steps of the simulation so far
  std::size_t again_ = 0;                         ///< pieces dropped again so far
  std::size_t reported_ = 0;                      ///< the largest number of resting pieces reported so far
};

}  // namespace

Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
               const SettleOptions& options) {
  if (items.empty()) return {};
  return Settling(solids, items, dish, options).run();
}

}  // namespace pomona
