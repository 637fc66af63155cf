#include "generator/scene/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/faults.h"
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

/// A state of the heap that was measured.
struct Measured {
  Settled settled;
  std::vector<Fault> faults;
};

class Settling {
 public:
  Settling(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
           const SettleOptions& options)
      : solids_(solids),
        items_(items),
        options_(options),
        name_(dish.name),
        purpose_(dish.turned ? "scene/drop" : "scene/drop/" + dish.name),
        draw_({options.seed, 0}, purpose_),
        shapes_(prepared()),
        dish_(dish, {.cell = unit_ / 24, .around = 2 * widest_ + unit_, .ground = ground_needed()}),
        heap_(dish_, items.size(), unit_, widest_, options.heap, options.threads),
        check_(solids, solid_numbers(), dish_.mesh(), options.threads) {}

  Settled run() {
    refuse_shallow_dish();
    find_starts();
    drop_in_waves();
    come_to_rest_without_funnel();
    Measured best;
    for (int attempt = 1; attempt <= std::max(1, options_.attempts); ++attempt) {
      if (attempt > 1 && !drop_again(movable(best.faults))) break;
      lift_doubtful_pieces();
      Measured now = measured();
      now.settled.attempts = attempt;
      if (attempt == 1 || now.faults.size() <= best.faults.size()) best = std::move(now);
      if (best.faults.empty()) break;
    }
    if (!may_pass(best.faults, items_.size(), options_)) give_up(best.faults, items_);
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

  const PieceArrangement* arrangement(std::size_t item) const {
    const int index = items_[item].arrangement;
    return index < 0 ? nullptr : &options_.arrangements[static_cast<std::size_t>(index)];
  }

  /// It does not fall: it is set to its place.
  bool is_set(std::size_t item) const {
    const PieceArrangement* how = arrangement(item);
    return how && how->kind != PieceArrangementKind::heap && how->kind != PieceArrangementKind::as_cut;
  }

  [[noreturn]] void refuse(const SourcePlace& place, const std::string& message, const std::string& hint) const {
    throw Error(ExitStatus::bad_data, {{place, message, hint}});
  }

  void refuse_shallow_dish() const {
    const auto falls = [&](const SettleItem& item) {
      return !item.beside && !is_set(static_cast<std::size_t>(&item - items_.data()));
    };
    const auto first = std::find_if(items_.begin(), items_.end(), falls);
    if (first == items_.end() || dish_.holds()) return;
    refuse(first->place, "\"" + name_ + "\" has no hollow that could hold pieces",
           "lay them \"on\" it, or give it a rim");
  }

  /// Where those begin that are not dropped from places drawn.
  void find_starts() {
    starts_.resize(items_.size());
    const RandomStream draw({options_.seed, 0}, purpose_ + "/arrange");
    ArrangeOptions arranging{options_.heap, unit_, widest_, {}, options_.threads};
    for (std::size_t k = 0; k < options_.arrangements.size(); ++k) {
      const PieceArrangement& how = options_.arrangements[k];
      std::vector<Arranged> pieces;
      for (std::size_t i = 0; i < items_.size(); ++i) {
        const SettleItem& item = items_[i];
        if (item.arrangement != static_cast<int>(k) || how.kind == PieceArrangementKind::heap) continue;
        const Attitude attitude = item.upright ? Attitude::upright : item.face_up ? Attitude::face_up : Attitude::any;
        pieces.push_back({i, &shape(i), &solids_[static_cast<std::size_t>(item.solid)], attitude, item.fruit});
      }
      if (pieces.empty()) continue;
      if (how.kind == PieceArrangementKind::scatter && !has_upper_side(dish_))
        refuse(items_[pieces[0].piece].place, "\"" + name_ + "\" has no area that looks upwards to scatter pieces on",
               "scatter them on a dish with a mesh");
      const auto found = arranged(pieces, how, dish_, draw, arranging);
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        starts_[pieces[i].piece] = found[i];
        if (found[i]) arranging.there.emplace_back(*pieces[i].shape, found[i]->rotation, found[i]->center);
      }
    }
  }

  DropArea area_of(std::size_t item) const {
    const PieceArrangement* how = arrangement(item);
    const double radius = shape(item).radius;
    if (in_bowl(item) && dish_.form()) return cells_for(radius, how);
    DropRing ring = ring_of(item);
    if (how && how->within > 0) {
      ring.inner = 0;
      ring.outer = how->within;
      ring.middle = how->at;
    }
    return ring;
  }

  /// Of a dish that is not turned: so far from its walls that a piece does not begin in them.
  DropCells cells_for(double radius, const PieceArrangement* how) const {
    double widest = 0;
    for (const MeshDish::Place& place : dish_.form()->places()) widest = std::max(widest, place.inset);
    const double inset = std::min(0.8 * radius, 0.7 * widest);
    DropCells cells;
    for (const MeshDish::Place& place : dish_.form()->places()) {
      if (place.inset < inset) continue;
      if (how && how->within > 0 && glm::distance(place.at, how->at) > how->within) continue;
      cells.push_back(place);
    }
    return cells;
  }

  DropRing ring_of(std::size_t item) const {
    const double radius = shape(item).radius, rim = dish_.rim_radius();
    // A piece may begin leaning on the wall: it slides down, and heaps spread as wide as the bowl is.
    if (in_bowl(item)) return {0, std::max(0.0, options_.fill * rim - 0.65 * radius), rim, dish_.rim_height()};
    if (items_[item].beside) return {rim + radius, options_.around * std::max(rim, 2 * widest_)};
    return {0, std::max(0.0, spread() - radius)};
  }

  HeightMap empty_map() const {
    double half = dish_.form() ? dish_.rim_radius() : 0;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      half = std::max(half, ring_of(i).outer + shape(i).radius);
      const PieceArrangement* how = arrangement(i);
      if (how) half = std::max(half, glm::length(how->at) + how->within + shape(i).radius);
    }
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
    const DropArea where = area_of(first);
    if (const auto* cells = std::get_if<DropCells>(&where)) {
      const double all = static_cast<double>(cells->size()) * dish_.form()->cell_area();
      return std::max(least, static_cast<std::size_t>(0.8 * all / footprint));
    }
    const auto& ring = std::get<DropRing>(where);
    const double area = pi * (ring.outer + 0.5 * unit_) * (ring.outer + 0.5 * unit_) - pi * ring.inner * ring.inner;
    return std::max(least, static_cast<std::size_t>(0.8 * area / footprint));
  }

  Funnel funnel() const {
    if (!dish_.has_bowl()) return {};
    if (const MeshDish* form = dish_.form()) {
      const Box<double>& box = form->box();
      return {.low = 0.9 * dish_.rim_height(), .from = {box.low.x, box.low.z}, .to = {box.high.x, box.high.z}};
    }
    return {.radius = options_.fill * dish_.rim_radius(), .low = 0.9 * dish_.rim_height()};
  }

  /// A layer at a time. The last layers stay movable; what lies deeper than these is at rest for good.
  void drop_in_waves() {
    constexpr std::size_t movable_waves = 2;
    std::vector<int> orders;
    for (const SettleItem& item : items_) orders.push_back(item.order);
    std::vector<std::size_t> order = dropping_order(orders, draw_);
    const double footprint = mean_footprint();
    heap_.set_funnel(funnel());
    HeightMap frozen = empty_map();
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
      const std::size_t first = done, end = std::min(order.size(), done + pieces_in_wave(order[done], footprint));
      while (done < end && (place(order[done], 0, map) || done == first)) ++done;
      settle_heap();
    }
  }

  /// What is set, and what is let go in a place of its own, comes before all that is dropped: the first wave. Brings
  /// these to the front of the order; returns how many are let go or have found no place.
  std::size_t start_arranged(std::vector<std::size_t>& order, HeightMap& frozen) {
    const auto is_arranged = [&](std::size_t item) {
      const PieceArrangement* how = arrangement(item);
      return how && how->kind != PieceArrangementKind::heap;
    };
    const auto last = std::stable_partition(order.begin(), order.end(), is_arranged);
    if (last == order.begin()) return 0;
    for (auto item = order.begin(); item != last; ++item) {
      if (!is_set(*item) || !starts_[*item]) continue;
      heap_.put(*item, RigidBody(shape(*item), starts_[*item]->rotation, starts_[*item]->center));
      heap_.fix(*item);
      raise(*item, frozen);
    }
    for (auto item = order.begin(); item != last; ++item)
      if (!is_set(*item)) let_go(*item, 0);
    settle_heap();
    return static_cast<std::size_t>(last - order.begin());
  }

  /// From where it is to begin. When it is dropped again it is turned a little.
  void let_go(std::size_t item, std::uint64_t round) {
    if (!starts_[item]) return;
    constexpr double most_turn = 0.2;
    const std::uint64_t counter = draws_per_drop * (item + round * items_.size());
    const double turn = round > 0 ? most_turn * (2 * draw_.uniform(counter) - 1) : 0;
    RigidBody body(shape(item), turn_about({0, 1, 0}, turn) * starts_[item]->rotation, starts_[item]->center);
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
    const std::uint64_t counter = draws_per_drop * (item + round * items_.size());
    glm::dvec3 up = items_[item].face_up ? shape(item).up : glm::dvec3(0);
    if (items_[item].upright) up = {0, 1, 0};
    RigidBody body(shape(item), drawn_rotation(up, draw_, counter), glm::dvec3(0));
    DropArea area = area_of(item);
    auto* const ring = std::get_if<DropRing>(&area);
    if (ring && round > 0 && in_bowl(item)) ring->outer *= 0.7;  // away from the rim, where room is more often found
    const std::optional<glm::dvec3> at = drawn_place(body, map, area, draw_, counter + 8);
    if (!at) return false;
    body.center = *at + glm::dvec3(0, 0.05 * unit_, 0);
    body.refresh();
    lift_clear(item, body);
    map.raise(body);
    heap_.put(item, body);
    return true;
  }

  /// The map is coarse, and seen from above only.
  void lift_clear(std::size_t item, RigidBody& body) const {
    constexpr int most_lifts = 60;
    const double air = 0.02 * unit_;
    for (int lift = 0; lift < most_lifts; ++lift) {
      const double clear = heap_.clearance(item, body, air);
      if (clear >= 0.99 * air) break;
      body.center.y += std::max(0.03 * unit_, air - clear);
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
    if (options_.progress) options_.progress("settle", told_, items_.size());
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
    HeightMap map = empty_map();
    for (std::size_t i = 0; i < items_.size(); ++i) raise(i, map);
    heap_.set_funnel(funnel());
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
    const double most_gap = 0.9 * options_.most_gap, most_depth = 0.8 * options_.most_penetration;
    for (int k = 0; k < most_rounds; ++k) {
      std::vector<std::uint8_t> is_bad(items_.size());
      parallel_for(items_.size(), options_.threads, [&](std::size_t i) {
        const RigidBody& body = heap_.bodies()[i];
        if (is_set(i)) return;
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

  /// Beyond the rim, or under the dish.
  bool is_outside(std::size_t item, const Pose& pose) const {
    if (!in_bowl(item)) return false;
    const Solid& solid = solids_[static_cast<std::size_t>(items_[item].solid)];
    const glm::dmat3 turn = glm::mat3_cast(pose.rotation);
    for (const glm::vec3& position : solid.position) {
      const glm::dvec3 p = turn * glm::dvec3(position) + pose.translation;
      if (!dish_.covers(p) || p.y < (dish_.form() ? -1e-4 : 0)) return true;
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
      std::optional<Fault> fault = fault_in(i, result.settled);
      if (fault) result.faults.push_back(std::move(*fault));
    }
    return result;
  }

  std::optional<Fault> fault_in(std::size_t item, const Settled& settled) const {
    if (heap_.bodies()[item].state == BodyState::out) return Fault{item, "finds no room in the " + name_};
    if (is_outside(item, settled.poses[item])) return Fault{item, "lies outside the " + name_};
    return fault_of(item, settled.fits[item], options_);
  }

  /// Those that can be dropped again.
  std::vector<std::size_t> movable(const std::vector<Fault>& faults) const {
    std::vector<std::size_t> pieces;
    for (const Fault& fault : faults)
      if (!is_set(fault.piece)) pieces.push_back(fault.piece);
    return pieces;
  }

  std::span<const Solid> solids_;
  std::span<const SettleItem> items_;
  SettleOptions options_;
  std::string name_;     ///< of the dish
  std::string purpose_;  ///< what draws of this heap are made for
  RandomStream draw_;
  double unit_ = 0, widest_ = 0;  ///< metres: the mean size of the pieces, the radius of the widest
  std::vector<PieceShape> shapes_;
  Dish dish_;
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
