#include "generator/scene/settle/heap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "generator/scene/settle/contact_solver.h"

namespace pomona {

namespace {

bool boxes_near(const RigidBody& a, const RigidBody& b, float reach) {
  return Box<float>{a.box.low - reach, a.box.high + reach}.meets(b.box);
}

Motion motion_of(const RigidBody& body) {
  return {glm::vec3(body.velocity), glm::vec3(body.spin), static_cast<float>(1 / body.shape->mass),
          glm::mat3(body.inverse_inertia)};
}

/// At most so long.
glm::dvec3 limited(const glm::dvec3& v, double most) {
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}

}  // namespace

Heap::Heap(const Dish& dish, std::size_t bodies, double unit, double widest, const HeapOptions& options,
           Threads threads)
    : dish_(dish),
      unit_(unit),
      widest_(widest),
      options_(options),
      threads_(threads),
      bodies_(bodies),
      frozen_(reach()),
      loose_(reach()) {}

bool Heap::is_active(std::size_t place) const {
  return place != dish_place && bodies_[place].state == BodyState::active;
}

void Heap::put(std::size_t place, const RigidBody& body) {
  bodies_[place] = body;
  loose_.add(place, body.center);
  pairs_known_ = false;
}

void Heap::freeze(std::size_t place) {
  bodies_[place].stop();
  bodies_[place].state = BodyState::frozen;
  frozen_known_ = pairs_known_ = false;
}

void Heap::fix(std::size_t place) {
  freeze(place);
  bodies_[place].is_fixed = true;
}

void Heap::wake() {
  for (RigidBody& body : bodies_)
    if (body.state == BodyState::asleep) body.state = BodyState::active, body.still_steps = 0;
  pairs_known_ = false;
}

void Heap::take_out(std::size_t place) {
  find_frozen();
  for (const std::size_t other : partners_of(place)) {
    RigidBody& beside = bodies_[other];
    if (beside.is_fixed) continue;
    if (!boxes_near(bodies_[place], beside, static_cast<float>(0.05 * unit_))) continue;
    if (beside.state == BodyState::frozen) {
      frozen_known_ = false;
      loose_.add(other, beside.center);
    }
    beside.state = BodyState::active;
    beside.still_steps = 0;
  }
  bodies_[place].state = BodyState::out;

  // What comes back to this place is another body: nothing that was known of pairs with the old one holds for it.
  std::erase_if(pairs_, [&](const Pair& pair) { return pair.first == place || pair.second == place; });
  pairs_known_ = false;
}

std::size_t Heap::resting() const {
  return static_cast<std::size_t>(std::count_if(bodies_.begin(), bodies_.end(), [](const RigidBody& body) {
    return body.state == BodyState::asleep || body.state == BodyState::frozen;
  }));
}

void Heap::find_frozen() {
  if (frozen_known_) return;
  frozen_ = NearBodies(reach(), bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].state == BodyState::frozen) frozen_.add(i, bodies_[i].center);
  frozen_known_ = true;
}

/// All bodies that may be near, sorted; each once.
std::vector<std::size_t> Heap::partners_of(std::size_t place) const {
  std::vector<std::size_t> partners;
  const auto note = [&](std::size_t other) {
    if (other != place && bodies_[other].state != BodyState::out) partners.push_back(other);
  };
  frozen_.visit(bodies_[place].center, note);
  loose_.visit(bodies_[place].center, note);
  std::sort(partners.begin(), partners.end());
  partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
  return partners;
}

double Heap::clearance(std::size_t place, const RigidBody& body, double within) const {
  float nearest = distance_to(dish_, body, static_cast<float>(within));
  const auto meet = [&](std::size_t other) {
    const RigidBody& beside = bodies_[other];
    if (other == place || beside.state == BodyState::out || !boxes_near(body, beside, nearest)) return;
    nearest = std::min(nearest, distance_between(body, beside, nearest));
  };
  frozen_.visit(body.center, meet);
  loose_.visit(body.center, meet);
  return nearest;
}

/// Sorted by places; what is known of a pair that stays is kept.
void Heap::find_pairs() {
  find_frozen();
  Places loose;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].is_loose()) loose.push_back(i);
  loose_ = NearBodies(reach(), loose.size());
  for (const std::size_t i : loose) loose_.add(i, bodies_[i].center);

  const auto slack = static_cast<float>((2 * options_.slack + 0.05) * unit_);
  std::vector<Pair> found;
  auto known = pairs_.begin();
  const auto add = [&](std::size_t first, std::size_t second) {
    const auto is_before = [&](const Pair& p) { return p.first != first ? p.first < first : p.second < second; };
    while (known != pairs_.end() && is_before(*known)) ++known;
    if (known != pairs_.end() && known->first == first && known->second == second) {
      found.push_back(std::move(*known));
    } else {
      found.push_back({first, second, {}});
    }
  };
  for (const std::size_t i : loose) {
    for (const std::size_t j : partners_of(i)) {
      if (bodies_[j].is_loose() && j < i) continue;
      if (boxes_near(bodies_[i], bodies_[j], slack)) add(i, j);
    }
    add(i, dish_place);
  }
  pairs_ = std::move(found);
  pairs_known_ = true;
  moved_ = 0;
}

void Heap::find_contacts(Pair& pair) const {
  const RigidBody& a = bodies_[pair.first];
  const double margin = options_.margin * unit_ + a.speed;
  if (pair.second == dish_place) {
    const bool is_far = dish_.distance(glm::vec3(a.center)) > static_cast<float>(a.shape->radius + margin);
    pair.contact = is_far ? std::vector<Contact>{} : contacts_with(dish_, a, static_cast<float>(margin), pair.contact);
    return;
  }
  const RigidBody& b = bodies_[pair.second];
  const float reach = std::min(a.shape->distance.reach(), b.shape->distance.reach());
  if (!boxes_near(a, b, reach)) {
    pair.contact.clear();
    return;
  }

  // What was clear by more than both have moved since is clear still.
  pair.clear -= (a.way - pair.first_way) + (b.way - pair.second_way);
  pair.first_way = a.way;
  pair.second_way = b.way;
  if (pair.contact.empty() && pair.clear > a.speed + b.speed) return;
  const float near = std::min(static_cast<float>(margin + b.speed), reach);
  PairContacts contacts = contacts_between(a, b, near, pair.contact);
  pair.contact = std::move(contacts.contact);
  pair.clear = pair.contact.empty() ? contacts.clear - options_.margin * unit_ : 0;
}

double Heap::smaller_size(const Pair& pair) const {
  const double size = bodies_[pair.first].shape->size;
  return pair.second == dish_place ? size : std::min(size, bodies_[pair.second].shape->size);
}

void Heap::step(double keep_velocity, double keep_spin) {
  // Gravity pulls, and air that is thicker than air brakes.
  if (!pairs_known_ || moved_ > options_.slack * unit_) find_pairs();
  Places active;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!is_active(i)) continue;
    active.push_back(i);
    RigidBody& body = bodies_[i];
    body.velocity.y -= options_.gravity * unit_;
    body.velocity *= keep_velocity;
    body.spin *= keep_spin;
    body.speed = glm::length(body.velocity) + body.shape->radius * glm::length(body.spin);
  }

  // Contacts of all pairs that move, each pair by itself; blocks of pairs, because one is little work.
  Places moving;
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    if (is_active(pairs_[k].first) || is_active(pairs_[k].second)) moving.push_back(k);
  constexpr std::size_t block = 64;
  parallel_for((moving.size() + block - 1) / block, threads_, [&](std::size_t b) {
    for (std::size_t k = b * block; k < std::min(moving.size(), (b + 1) * block); ++k) find_contacts(pairs_[moving[k]]);
  });
  std::erase_if(moving, [&](std::size_t k) { return pairs_[k].contact.empty(); });
  let_act(active, moving);
  rest(active, moving);
}

/// Finds the impulses, moves the bodies, and takes out of their velocities what only parted them.
void Heap::let_act(const Places& active, const Places& touching) {
  // What does not move shares one motion, the last.
  std::vector<Motion> motions;
  Places motion(bodies_.size(), 0);
  for (const std::size_t i : active) {
    motion[i] = motions.size();
    motions.push_back(motion_of(bodies_[i]));
  }
  const std::size_t fixed = motions.size();
  motions.emplace_back();
  ContactSolver solver(std::move(motions));
  for (const std::size_t k : touching) {
    const Pair& pair = pairs_[k];
    const double size = smaller_size(pair);
    ContactEnds ends{fixed, fixed};
    if (is_active(pair.first)) ends.first = motion[pair.first];
    if (is_active(pair.second)) ends.second = motion[pair.second];
    for (const Contact& contact : pair.contact) {
      ends.first_arm = contact.point - glm::vec3(bodies_[pair.first].center);
      if (pair.second != dish_place) ends.second_arm = contact.point - glm::vec3(bodies_[pair.second].center);

      // What is jammed by friction must be able to slip out.
      const double depth = std::max(0.0, -static_cast<double>(contact.distance));
      const double jammed = (depth / size - 0.4 * options_.pressed) / (0.6 * options_.pressed);
      const double friction = friction_ * std::clamp(1 - jammed, 0.1, 1.0);
      const double push =
          std::min(options_.push * unit_, options_.push_share * std::max(0.0, depth - options_.slop * unit_));
      solver.add(contact, ends, static_cast<float>(friction), static_cast<float>(push));
    }
  }

  for (int sweep = 0; sweep < options_.sweeps; ++sweep) solver.sweep(sweep % 2 == 0);
  const auto take_over = [&] {
    for (std::size_t i = 0; i < active.size(); ++i) {
      bodies_[active[i]].velocity = solver.motions()[i].velocity;
      bodies_[active[i]].spin = solver.motions()[i].spin;
    }
  };
  take_over();
  move(active);
  solver.relax();
  for (int sweep = 0; sweep < options_.relaxing_sweeps; ++sweep) solver.sweep(sweep % 2 == 0);
  take_over();

  // Contacts keep what the next step starts from.
  std::size_t row = 0;
  for (const std::size_t k : touching) {
    for (Contact& contact : pairs_[k].contact) {
      contact.impulse = solver.impulse(row);
      contact.distance = solver.distance(row);
      contact.presses = solver.presses(row);
      ++row;
    }
  }
}

void Heap::keep_in_funnel(RigidBody& body) const {
  if (body.center.y < funnel_.low) return;
  if (funnel_.from != funnel_.to) {
    const double radius = body.shape->radius;
    for (const int axis : {0, 2}) {
      double& velocity = body.velocity[axis];
      if (body.center[axis] + radius > funnel_.to[axis / 2]) velocity = std::min(velocity, 0.0);
      if (body.center[axis] - radius < funnel_.from[axis / 2]) velocity = std::max(velocity, 0.0);
    }
  }
  if (funnel_.radius <= 0) return;
  const glm::dvec3 outwards(body.center.x, 0, body.center.z);
  const double distance = glm::length(outwards);
  if (distance <= 0 || distance + body.shape->radius < funnel_.radius) return;
  const double leaving = glm::dot(body.velocity, outwards) / distance;
  if (leaving > 0) body.velocity -= outwards * (leaving / distance);
}

void Heap::move(const Places& active) {
  double fastest = 0;
  for (const std::size_t i : active) {
    RigidBody& body = bodies_[i];
    keep_in_funnel(body);
    body.velocity = limited(body.velocity, options_.fastest * unit_);
    body.spin = limited(body.spin, 2 * options_.fastest);
    body.advance();
    fastest = std::max(fastest, body.speed);
  }
  moved_ += fastest;
}

double Heap::deepest(const Pair& pair) const {
  double depth = 0;
  for (const Contact& contact : pair.contact) depth = std::max(depth, -static_cast<double>(contact.distance));
  return depth;
}

/// Who lies still for some steps falls asleep, unless it lies on nothing, overlaps too much, or is pushed.
void Heap::rest(const Places& active, const Places& touching) {
  const double still = options_.still * unit_;
  std::vector<std::uint8_t> carried(bodies_.size()), pressed(bodies_.size()), disturbed(bodies_.size());
  const auto disturb = [&](std::size_t mover, std::size_t other) {
    if (!is_active(mover)) return;
    const double motion = bodies_[mover].motion();
    if (motion > 2 * still) disturbed[other] = 1;
    if (motion <= 8 * still || bodies_[other].state != BodyState::asleep) return;
    bodies_[other].state = BodyState::active;
    bodies_[other].still_steps = 0;
  };
  pressed_ = 0;
  for (const std::size_t k : touching) {
    const Pair& pair = pairs_[k];
    const bool has_second = pair.second != dish_place;
    if (deepest(pair) > options_.pressed * smaller_size(pair)) {
      ++pressed_;
      pressed[pair.first] = 1;
      if (has_second) pressed[pair.second] = 1;
    }
    const auto presses = [](const Contact& contact) { return contact.presses; };
    if (std::none_of(pair.contact.begin(), pair.contact.end(), presses)) continue;
    carried[pair.first] = 1;
    if (!has_second) continue;
    carried[pair.second] = 1;
    disturb(pair.first, pair.second);
    disturb(pair.second, pair.first);
  }

  for (const std::size_t i : active) {
    RigidBody& body = bodies_[i];
    const bool is_still = body.motion() < still && carried[i] != 0 && pressed[i] == 0;
    body.still_steps = is_still ? body.still_steps + 1 : 0;
    if (body.still_steps < options_.still_steps || disturbed[i] != 0) continue;
    body.stop();
    body.state = BodyState::asleep;
  }
}

/// Steps until nothing is faster than `still`, units a step, for some steps; the most if something still is.
int Heap::run(int most, double keep_velocity, double keep_spin, double still, const std::function<void()>& after_step) {
  constexpr int calm_steps = 8;
  const bool is_last = still <= options_.still;
  int calm = 0;
  for (int count = 1; count <= most; ++count) {
    step(keep_velocity, keep_spin);
    if (after_step) after_step();
    double fastest = -1;
    for (const RigidBody& body : bodies_)
      if (body.state == BodyState::active) fastest = std::max(fastest, body.motion());
    if (fastest < 0) return count;
    const bool is_calm = fastest < still * unit_ && (!is_last || pressed_ == 0);
    calm = is_calm ? calm + 1 : 0;
    if (calm >= calm_steps) return count;
  }
  return most;
}

int Heap::settle(const std::function<void()>& after_step) {
  // They fall, slippery; then come to rest in ever thicker air.
  friction_ = std::min(options_.slippery, options_.friction);
  int steps = run(options_.most_steps / 2, 0.97, 0.94, 8 * options_.still, after_step);
  friction_ = options_.friction;
  steps += run(options_.most_steps / 8, 0.9, 0.8, 2 * options_.still, after_step);
  return steps + run(options_.most_steps - steps, 0.7, 0.6, options_.still, after_step);
}

}  // namespace pomona
