// The steps of a rigid-body world, until it is at rest.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "generator/scene/settle/contact_solver.h"
#include "generator/scene/settle/rigid_body_world.h"

namespace pomona {

namespace {

BodyMotion motion_of(const RigidBody& body) {
  return {glm::vec3(body.velocity), glm::vec3(body.spin), static_cast<float>(1 / body.shape->mass),
          glm::mat3(body.inverse_inertia)};
}

/// The vector, shortened to `max_length` where it is longer.
glm::dvec3 limited(const glm::dvec3& v, double max_length) {
  const double length = glm::length(v);
  return length > max_length ? v * (max_length / length) : v;
}

}  // namespace

double RigidBodyWorld::smaller_size(const Pair& pair) const {
  const double size = bodies_[pair.first].shape->size;
  return pair.second == dish_slot ? size : std::min(size, bodies_[pair.second].shape->size);
}

void RigidBodyWorld::step(double keep_velocity, double keep_spin) {
  // Gravity accelerates the bodies; damping slows them down.
  if (!pairs_are_current_ || moved_ > options_.pair_slack * unit_) find_pairs();
  Indices active;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!is_active(i)) continue;
    active.push_back(i);
    RigidBody& body = bodies_[i];
    body.velocity.y -= options_.gravity * unit_;
    body.velocity *= keep_velocity;
    body.spin *= keep_spin;
    body.speed = glm::length(body.velocity) + body.shape->radius * glm::length(body.spin);
  }

  // Narrow phase: the contacts of all pairs that move, each pair by itself. A task is a block of pairs, because one
  // pair is little work.
  Indices moving;
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    if (is_active(pairs_[k].first) || is_active(pairs_[k].second)) moving.push_back(k);
  constexpr std::size_t block = 64;
  parallel_for((moving.size() + block - 1) / block, threads_, [&](std::size_t b) {
    for (std::size_t k = b * block; k < std::min(moving.size(), (b + 1) * block); ++k)
      update_contacts(pairs_[moving[k]]);
  });
  std::erase_if(moving, [&](std::size_t k) { return pairs_[k].contacts.empty(); });
  solve_contacts(active, moving);
  update_sleep(active, moving);
}

/// Finds the impulses and moves the bodies. Then removes from the velocities what only corrected penetrations.
void RigidBodyWorld::solve_contacts(const Indices& active, const Indices& touching) {
  // All bodies that do not move share one motion, the last.
  std::vector<BodyMotion> motions;
  Indices motion(bodies_.size(), 0);
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
    ContactBodies ends{fixed, fixed};
    if (is_active(pair.first)) ends.first = motion[pair.first];
    if (is_active(pair.second)) ends.second = motion[pair.second];
    for (const Contact& contact : pair.contacts) {
      ends.first_arm = contact.point - glm::vec3(bodies_[pair.first].center);
      if (pair.second != dish_slot) ends.second_arm = contact.point - glm::vec3(bodies_[pair.second].center);

      // Deep contacts get less friction, so that a jammed piece can slip out.
      const double depth = std::max(0.0, -static_cast<double>(contact.distance));
      const double jammed =
          (depth / size - 0.4 * options_.max_resting_penetration) / (0.6 * options_.max_resting_penetration);
      const double friction = friction_ * std::clamp(1 - jammed, 0.1, 1.0);
      const double push =
          std::min(options_.max_correction * unit_,
                   options_.correction_share * std::max(0.0, depth - options_.penetration_slop * unit_));
      solver.add(contact, ends, static_cast<float>(friction), static_cast<float>(push));
    }
  }

  for (int sweep = 0; sweep < options_.sweeps; ++sweep) solver.sweep(sweep % 2 == 0);
  const auto copy_velocities = [&] {
    for (std::size_t i = 0; i < active.size(); ++i) {
      bodies_[active[i]].velocity = solver.motions()[i].velocity;
      bodies_[active[i]].spin = solver.motions()[i].spin;
    }
  };
  copy_velocities();
  integrate(active);
  solver.relax();
  for (int sweep = 0; sweep < options_.relax_sweeps; ++sweep) solver.sweep(sweep % 2 == 0);
  copy_velocities();

  // Each contact keeps the result: the next step starts from it.
  std::size_t row = 0;
  for (const std::size_t k : touching) {
    for (Contact& contact : pairs_[k].contacts) {
      contact.impulse = solver.impulse(row);
      contact.distance = solver.distance(row);
      contact.is_loaded = solver.is_loaded(row);
      ++row;
    }
  }
}

void RigidBodyWorld::apply_funnel(RigidBody& body) const {
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

void RigidBodyWorld::integrate(const Indices& active) {
  double fastest = 0;
  for (const std::size_t i : active) {
    RigidBody& body = bodies_[i];
    apply_funnel(body);
    body.velocity = limited(body.velocity, options_.max_speed * unit_);
    body.spin = limited(body.spin, 2 * options_.max_speed);
    body.advance();
    fastest = std::max(fastest, body.speed);
  }
  moved_ += fastest;
}

double RigidBodyWorld::penetration_of(const Pair& pair) const {
  double depth = 0;
  for (const Contact& contact : pair.contacts) depth = std::max(depth, -static_cast<double>(contact.distance));
  return depth;
}

/// A body that is still for some steps falls asleep, unless nothing supports it, it penetrates too deep, or a moving
/// body pushes it.
void RigidBodyWorld::update_sleep(const Indices& active, const Indices& touching) {
  const double sleep_speed = options_.sleep_speed * unit_;
  std::vector<std::uint8_t> supported(bodies_.size()), too_deep(bodies_.size()), disturbed(bodies_.size());
  const auto disturb = [&](std::size_t mover, std::size_t other) {
    if (!is_active(mover)) return;
    const double motion = bodies_[mover].typical_speed();
    if (motion > 2 * sleep_speed) disturbed[other] = 1;
    if (motion <= 8 * sleep_speed || bodies_[other].state != BodyState::asleep) return;
    bodies_[other].state = BodyState::active;
    bodies_[other].steps_at_rest = 0;
  };
  deep_pairs_ = 0;
  for (const std::size_t k : touching) {
    const Pair& pair = pairs_[k];
    const bool has_second = pair.second != dish_slot;
    if (penetration_of(pair) > options_.max_resting_penetration * smaller_size(pair)) {
      ++deep_pairs_;
      too_deep[pair.first] = 1;
      if (has_second) too_deep[pair.second] = 1;
    }
    const auto is_loaded = [](const Contact& contact) { return contact.is_loaded; };
    if (std::none_of(pair.contacts.begin(), pair.contacts.end(), is_loaded)) continue;
    supported[pair.first] = 1;
    if (!has_second) continue;
    supported[pair.second] = 1;
    disturb(pair.first, pair.second);
    disturb(pair.second, pair.first);
  }

  for (const std::size_t i : active) {
    RigidBody& body = bodies_[i];
    const bool is_still = body.typical_speed() < sleep_speed && supported[i] != 0 && too_deep[i] == 0;
    body.steps_at_rest = is_still ? body.steps_at_rest + 1 : 0;
    if (body.steps_at_rest < options_.sleep_steps || disturbed[i] != 0) continue;
    body.stop();
    body.state = BodyState::asleep;
  }
}

/// Steps until no body is faster than `rest_speed`, units a step, for some steps. Returns the number of steps, at most
/// `max_steps`.
int RigidBodyWorld::run_phase(int max_steps, double keep_velocity, double keep_spin, double rest_speed,
                              const std::function<void()>& after_step) {
  constexpr int calm_steps = 8;
  const bool is_last = rest_speed <= options_.sleep_speed;
  int calm = 0;
  for (int count = 1; count <= max_steps; ++count) {
    step(keep_velocity, keep_spin);
    if (after_step) after_step();
    double fastest = -1;
    for (const RigidBody& body : bodies_)
      if (body.state == BodyState::active) fastest = std::max(fastest, body.typical_speed());
    if (fastest < 0) return count;
    const bool is_calm = fastest < rest_speed * unit_ && (!is_last || deep_pairs_ == 0);
    calm = is_calm ? calm + 1 : 0;
    if (calm >= calm_steps) return count;
  }
  return max_steps;
}

int RigidBodyWorld::run_until_rest(const std::function<void()>& after_step) {
  // The bodies fall with little friction; then they come to rest under growing friction and damping.
  friction_ = std::min(options_.falling_friction, options_.friction);
  int steps = run_phase(options_.max_steps / 2, 0.97, 0.94, 8 * options_.sleep_speed, after_step);
  friction_ = options_.friction;
  steps += run_phase(options_.max_steps / 8, 0.9, 0.8, 2 * options_.sleep_speed, after_step);
  return steps + run_phase(options_.max_steps - steps, 0.7, 0.6, options_.sleep_speed, after_step);
}

}  // namespace pomona
