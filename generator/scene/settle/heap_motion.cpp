// How a heap moves: its steps, until it is at rest.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "generator/scene/settle/contact_solver.h"
#include "generator/scene/settle/heap.h"

namespace pomona {

namespace {

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
