#include "generator/scene/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/height_map.h"

namespace pomona {

namespace {

double rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

Pose rounded(Pose pose) {
  const glm::dquat q = pose.rotation.w < 0 ? -pose.rotation : pose.rotation;
  pose.rotation = glm::dquat(rounded(q.w), rounded(q.x), rounded(q.y), rounded(q.z));
  for (int k = 0; k < 3; ++k) pose.translation[k] = rounded(pose.translation[k]);
  return pose;
}

/// What is wrong with a piece; nothing if it lies well.
struct Fault {
  std::size_t piece = 0;
  std::string what;
  bool is_grave = true;  ///< not even one in many may have it
};

/// A state of the heap that was measured.
struct Measured {
  Settled settled;
  std::vector<Fault> faults;
};

class Settling {
 public:
  Settling(std::span<const Solid> solids, std::span<const SettleItem> items, const Solid* bowl,
           const SettleOptions& options)
      : solids_(solids),
        items_(items),
        options_(options),
        draw_({options.seed, 0}, "scene/drop"),
        shapes_(prepared()),
        dish_(bowl, {.cell = unit_ / 24, .around = 2 * widest_ + unit_, .ground = ground_needed()}),
        heap_(dish_, items.size(), unit_, widest_, options.heap, options.threads),
        check_(solids, solid_numbers(), dish_.mesh(), options.threads) {}

  Settled run() {
    drop_in_waves();
    come_to_rest_without_funnel();
    Measured best;
    for (int attempt = 1; attempt <= std::max(1, options_.attempts); ++attempt) {
      if (attempt > 1) drop_again(faulty(best.faults));
      lift_doubtful_pieces();
      Measured now = measured();
      now.settled.attempts = attempt;
      if (attempt == 1 || now.faults.size() <= best.faults.size()) best = std::move(now);
      if (best.faults.empty()) break;
    }
    if (!may_pass(best.faults)) give_up(best.faults);
    return std::move(best.settled);
  }

 private:
  const PieceShape& shape(std::size_t item) const { return shapes_[static_cast<std::size_t>(items_[item].solid)]; }

  std::vector<std::size_t> solid_numbers() const {
    std::vector<std::size_t> numbers;
    for (const SettleItem& item : items_) numbers.push_back(static_cast<std::size_t>(item.solid));
    return numbers;
  }

  /// Shapes of the solids that are placed. Sets unit_ and widest_, which what follows is made with.
  std::vector<PieceShape> prepared() {
    constexpr std::size_t all_cells = 100'000'000;  // of all grids: 400 MB
    std::vector<std::uint8_t> used(solids_.size());
    std::vector<double> sizes(solids_.size());
    for (const SettleItem& item : items_) {
      const auto solid = static_cast<std::size_t>(item.solid);
      if (used[solid] == 0) sizes[solid] = size_of(solids_[solid]);
      used[solid] = 1;
      unit_ += sizes[solid] / static_cast<double>(items_.size());
    }
    const auto distinct = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
    const int cells = static_cast<int>(std::clamp<std::size_t>(all_cells / distinct, 8000, 40000));
    std::vector<PieceShape> shapes(solids_.size());
    parallel_for(solids_.size(), options_.threads, [&](std::size_t i) {
      if (used[i] != 0) shapes[i] = piece_shape(solids_[i], unit_, cells);
    });
    for (const PieceShape& made : shapes) widest_ = std::max(widest_, made.radius);
    return shapes;
  }

  /// Without a bowl the ground must reach under all pieces.
  double ground_needed() const { return 2 * spread() + 4 * unit_; }
  double spread() const { return options_.spread > 0 ? options_.spread : 4 * widest_; }

  bool in_bowl(std::size_t item) const { return dish_.has_bowl() && !items_[item].beside; }

  DropRing ring_of(std::size_t item) const {
    const double radius = shape(item).radius, rim = dish_.rim_radius();
    // A piece may begin leaning on the wall: it slides down, and heaps spread as wide as the bowl is.
    if (in_bowl(item)) return {0, std::max(0.0, options_.fill * rim - 0.65 * radius), rim, dish_.rim_height()};
    if (items_[item].beside) return {rim + radius, options_.around * std::max(rim, 2 * widest_)};
    return {0, std::max(0.0, spread() - radius)};
  }

  HeightMap empty_map() const {
    double half = 0;
    for (std::size_t i = 0; i < items_.size(); ++i) half = std::max(half, ring_of(i).outer + shape(i).radius);
    return {dish_, half, unit_ / 9};
  }

  /// Of the pieces, as they lie flat.
  double mean_footprint() const {
    double footprint = 0;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const glm::dvec3 size(shape(i).box.size());
      footprint += std::max({size.x * size.y, size.y * size.z, size.z * size.x});
    }
    return footprint / static_cast<double>(items_.size());
  }

  /// So many pieces cover the ring once.
  std::size_t pieces_in_wave(std::size_t first, double footprint) const {
    constexpr std::size_t least = 12;
    const DropRing ring = ring_of(first);
    const double area = pi * (ring.outer + 0.5 * unit_) * (ring.outer + 0.5 * unit_) - pi * ring.inner * ring.inner;
    return std::max(least, static_cast<std::size_t>(0.8 * area / footprint));
  }

  Funnel funnel() const {
    if (!dish_.has_bowl()) return {};
    return {options_.fill * dish_.rim_radius(), 0.9 * dish_.rim_height()};
  }

  /// A layer at a time. The last layers stay movable; what lies deeper than these is at rest for good.
  void drop_in_waves() {
    constexpr std::size_t movable_waves = 2;
    std::vector<int> orders;
    for (const SettleItem& item : items_) orders.push_back(item.order);
    const std::vector<std::size_t> order = dropping_order(orders, draw_);
    const double footprint = mean_footprint();
    std::vector<std::size_t> starts;
    heap_.set_funnel(funnel());
    HeightMap frozen = empty_map();
    for (std::size_t done = 0; done < order.size();) {
      if (starts.size() > movable_waves) {
        const std::size_t old = starts.size() - movable_waves - 1;
        for (std::size_t i = starts[old]; i < starts[old + 1]; ++i) freeze(order[i], frozen);
      }
      HeightMap map = frozen;
      for (std::size_t i = starts.size() > movable_waves ? starts[starts.size() - movable_waves] : 0; i < done; ++i)
        raise(order[i], map);
      starts.push_back(done);
      // Who finds no room has to wait until this wave has come to rest; who then finds none has to stay out.
      const std::size_t first = done, end = std::min(order.size(), done + pieces_in_wave(order[done], footprint));
      while (done < end && (place(order[done], 0, map) || done == first)) ++done;
      settle_heap();
    }
  }

  void freeze(std::size_t item, HeightMap& frozen) {
    if (heap_.bodies()[item].state == BodyState::out) return;
    heap_.freeze(item);
    raise(item, frozen);
  }

  void raise(std::size_t item, HeightMap& map) const {
    if (heap_.bodies()[item].state != BodyState::out) map.raise(heap_.bodies()[item]);
  }

  /// Turned as drawn, over the lowest of the places drawn, lifted until it is clear of all. False if there is no room.
  bool place(std::size_t item, std::uint64_t round, HeightMap& map) {
    const std::uint64_t counter = draws_per_drop * (item + round * items_.size());
    const glm::dvec3 up = items_[item].face_up ? shape(item).up : glm::dvec3(0);
    RigidBody body(shape(item), drawn_rotation(up, draw_, counter), glm::dvec3(0));
    DropRing ring = ring_of(item);
    if (round > 0 && in_bowl(item)) ring.outer *= 0.7;  // away from the rim, where room is more often found
    const std::optional<glm::dvec3> at = drawn_place(body, map, ring, draw_, counter + 8);
    if (!at) return false;
    body.center = *at + glm::dvec3(0, 0.05 * unit_, 0);
    body.refresh();

    // The map is coarse, and seen from above only.
    constexpr int most_lifts = 60;
    const double air = 0.02 * unit_;
    for (int lift = 0; lift < most_lifts; ++lift) {
      const double clear = heap_.clearance(item, body, air);
      if (clear >= 0.99 * air) break;
      body.center.y += std::max(0.03 * unit_, air - clear);
      body.refresh();
    }
    map.raise(body);
    heap_.put(item, body);
    return true;
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
    if (options_.progress) options_.progress("settle", told_, items_.size());
  }

  void come_to_rest_without_funnel() {
    heap_.set_funnel({});
    heap_.wake();
    settle_heap();
  }

  void drop_again(const std::vector<std::size_t>& pieces) {
    ++round_;
    again_ += pieces.size();
    for (const std::size_t item : pieces)
      if (heap_.bodies()[item].state != BodyState::out) heap_.take_out(item);
    HeightMap map = empty_map();
    for (std::size_t i = 0; i < items_.size(); ++i) raise(i, map);
    heap_.set_funnel(funnel());
    for (const std::size_t item : pieces) place(item, round_, map);
    settle_heap();
    heap_.set_funnel({});
  }

  /// What the grids say lies badly is dropped again before the real meshes are asked, which takes longer.
  void lift_doubtful_pieces() {
    constexpr int most_rounds = 6;
    const double most_gap = 0.9 * options_.most_gap, most_depth = 0.8 * options_.most_penetration;
    for (int k = 0; k < most_rounds; ++k) {
      std::vector<std::uint8_t> is_bad(items_.size());
      parallel_for(items_.size(), options_.threads, [&](std::size_t i) {
        const RigidBody& body = heap_.bodies()[i];
        if (body.state == BodyState::out) {
          is_bad[i] = 1;
          return;
        }
        const double clear = heap_.clearance(i, body, 2 * most_gap * body.shape->size);
        const bool bad = clear > most_gap * body.shape->size || clear < -most_depth * body.shape->size;
        is_bad[i] = bad || is_outside(i, body.pose()) ? 1 : 0;
      });
      std::vector<std::size_t> bad;
      for (std::size_t i = 0; i < items_.size(); ++i)
        if (is_bad[i] != 0) bad.push_back(i);
      if (bad.empty() || options_.attempts <= 1) return;
      drop_again(bad);
    }
  }

  /// Beyond the rim, or under the bowl.
  bool is_outside(std::size_t item, const Pose& pose) const {
    if (!in_bowl(item)) return false;
    const Solid& solid = solids_[static_cast<std::size_t>(items_[item].solid)];
    const glm::dmat3 turn = glm::mat3_cast(pose.rotation);
    for (const glm::vec3& position : solid.position) {
      const glm::dvec3 p = turn * glm::dvec3(position) + pose.translation;
      if (p.x * p.x + p.z * p.z > dish_.rim_radius() * dish_.rim_radius() || p.y < 0) return true;
    }
    return false;
  }

  /// By the real meshes, at the poses that a file can hold.
  Measured measured() {
    Measured result;
    for (const RigidBody& body : heap_.bodies())
      result.settled.poses.push_back(body.state == BodyState::out ? Pose{} : rounded(body.pose()));
    const auto tell = [&](std::size_t done) {
      if (options_.progress) options_.progress("measure", done, items_.size());
    };
    result.settled.fits = check_.measure(result.settled.poses, tell);
    result.settled.steps = steps_;
    result.settled.again = again_;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      std::optional<Fault> fault = fault_of(i, result.settled);
      if (fault) result.faults.push_back(std::move(*fault));
    }
    return result;
  }

  std::optional<Fault> fault_of(std::size_t item, const Settled& settled) const {
    if (heap_.bodies()[item].state == BodyState::out) return Fault{item, "finds no room in the bowl"};
    if (is_outside(item, settled.poses[item])) return Fault{item, "lies outside the bowl"};
    const Fit& fit = settled.fits[item];
    const bool is_grave = std::max(fit.gap, fit.penetration) > options_.most_of_few;
    char text[96] = "";
    if (fit.gap > options_.most_gap)
      std::snprintf(text, sizeof text, "keeps a gap of %.1f %% of its size", 100 * fit.gap);
    if (fit.penetration > options_.most_penetration)
      std::snprintf(text, sizeof text, "overlaps by %.1f %% of its size", 100 * fit.penetration);
    if (text[0] == '\0') return {};
    return Fault{item, text, is_grave};
  }

  static std::vector<std::size_t> faulty(const std::vector<Fault>& faults) {
    std::vector<std::size_t> pieces;
    for (const Fault& fault : faults) pieces.push_back(fault.piece);
    return pieces;
  }

  bool may_pass(const std::vector<Fault>& faults) const {
    const bool some_are_grave = std::any_of(faults.begin(), faults.end(), [](const Fault& f) { return f.is_grave; });
    return !some_are_grave && faults.size() * options_.few_of <= items_.size();
  }

  [[noreturn]] void give_up(const std::vector<Fault>& faults) const {
    constexpr std::size_t most_listed = 5;
    std::string message = "the pieces do not settle: ";
    for (std::size_t i = 0; i < std::min(faults.size(), most_listed); ++i)
      message += (i > 0 ? "; " : "") + ("piece \"" + items_[faults[i].piece].name + "\" " + faults[i].what);
    if (faults.size() > most_listed) message += "; and " + std::to_string(faults.size() - most_listed) + " more";
    throw Error(ExitStatus::some_items_failed, message, "a wider bowl, fewer pieces or another seed may help");
  }

  std::span<const Solid> solids_;
  std::span<const SettleItem> items_;
  SettleOptions options_;
  RandomStream draw_;
  double unit_ = 0, widest_ = 0;  ///< metres: the mean size of the pieces, the radius of the widest
  std::vector<PieceShape> shapes_;
  Dish dish_;
  Heap heap_;
  FitCheck check_;
  std::uint64_t round_ = 0;  ///< of dropping again
  int steps_ = 0;
  std::size_t again_ = 0, told_ = 0;
};

}  // namespace

Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const Solid* bowl,
               const SettleOptions& options) {
  if (items.empty()) return {};
  return Settling(solids, items, bowl, options).run();
}

}  // namespace pomona
