#include "generator/scene/settle/rigid_body_world.h"

#include <algorithm>

namespace pomona {

namespace {

bool boxes_near(const RigidBody& a, const RigidBody& b, float reach) {
  return Box<float>{a.box.low - reach, a.box.high + reach}.meets(b.box);
}

}  // namespace

RigidBodyWorld::RigidBodyWorld(const Dish& dish, std::size_t bodies, double unit, double widest,
                               const WorldOptions& options, Threads threads)
    : dish_(dish),
      unit_(unit),
      widest_(widest),
      options_(options),
      threads_(threads),
      bodies_(bodies),
      frozen_grid_(reach()),
      loose_grid_(reach()) {}

bool RigidBodyWorld::is_active(std::size_t slot) const {
  return slot != dish_slot && bodies_[slot].state == BodyState::active;
}

void RigidBodyWorld::put(std::size_t slot, const RigidBody& body) {
  bodies_[slot] = body;
  loose_grid_.add(slot, body.center);
  pairs_are_current_ = false;
}

void RigidBodyWorld::freeze(std::size_t slot) {
  bodies_[slot].stop();
  bodies_[slot].state = BodyState::frozen;
  frozen_grid_is_current_ = pairs_are_current_ = false;
}

void RigidBodyWorld::fix(std::size_t slot) {
  freeze(slot);
  bodies_[slot].is_fixed = true;
}

void RigidBodyWorld::wake_all() {
  for (RigidBody& body : bodies_)
    if (body.state == BodyState::asleep) body.state = BodyState::active, body.steps_at_rest = 0;
  pairs_are_current_ = false;
}

void RigidBodyWorld::remove(std::size_t slot) {
  update_frozen_grid();
  for (const std::size_t other : bodies_near(slot)) {
    RigidBody& beside = bodies_[other];
    if (beside.is_fixed) continue;
    if (!boxes_near(bodies_[slot], beside, static_cast<float>(0.05 * unit_))) continue;
    if (beside.state == BodyState::frozen) {
      frozen_grid_is_current_ = false;
      loose_grid_.add(other, beside.center);
    }
    beside.state = BodyState::active;
    beside.steps_at_rest = 0;
  }
  bodies_[slot].state = BodyState::absent;

  // The next body in this slot is another one: what is known of pairs with the old body does not hold for it.
  std::erase_if(pairs_, [&](const Pair& pair) { return pair.first == slot || pair.second == slot; });
  pairs_are_current_ = false;
}

std::size_t RigidBodyWorld::resting_count() const {
  return static_cast<std::size_t>(std::count_if(bodies_.begin(), bodies_.end(), [](const RigidBody& body) {
    return body.state == BodyState::asleep || body.state == BodyState::frozen;
  }));
}

void RigidBodyWorld::update_frozen_grid() {
  if (frozen_grid_is_current_) return;
  frozen_grid_ = BroadPhase(reach(), bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].state == BodyState::frozen) frozen_grid_.add(i, bodies_[i].center);
  frozen_grid_is_current_ = true;
}

/// All bodies that may be near the one in the slot, sorted, each once.
std::vector<std::size_t> RigidBodyWorld::bodies_near(std::size_t slot) const {
  std::vector<std::size_t> near;
  const auto add = [&](std::size_t other) {
    if (other != slot && bodies_[other].state != BodyState::absent) near.push_back(other);
  };
  frozen_grid_.visit(bodies_[slot].center, add);
  loose_grid_.visit(bodies_[slot].center, add);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

double RigidBodyWorld::clearance(std::size_t slot, const RigidBody& body, double within) const {
  float nearest = distance_to(dish_, body, static_cast<float>(within));
  const auto measure = [&](std::size_t other) {
    const RigidBody& beside = bodies_[other];
    if (other == slot || beside.state == BodyState::absent || !boxes_near(body, beside, nearest)) return;
    nearest = std::min(nearest, distance_between(body, beside, nearest));
  };
  frozen_grid_.visit(body.center, measure);
  loose_grid_.visit(body.center, measure);
  return nearest;
}

/// Runs the broad phase. Pairs are sorted by slots; a pair that was known before keeps its contacts.
void RigidBodyWorld::find_pairs() {
  update_frozen_grid();
  Indices loose;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].is_loose()) loose.push_back(i);
  loose_grid_ = BroadPhase(reach(), loose.size());
  for (const std::size_t i : loose) loose_grid_.add(i, bodies_[i].center);

  const auto slack = static_cast<float>((2 * options_.pair_slack + 0.05) * unit_);
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
    for (const std::size_t j : bodies_near(i)) {
      if (bodies_[j].is_loose() && j < i) continue;
      if (boxes_near(bodies_[i], bodies_[j], slack)) add(i, j);
    }
    add(i, dish_slot);
  }
  pairs_ = std::move(found);
  pairs_are_current_ = true;
  moved_ = 0;
}

void RigidBodyWorld::update_contacts(Pair& pair) const {
  const RigidBody& a = bodies_[pair.first];
  const double margin = options_.contact_margin * unit_ + a.speed;
  if (pair.second == dish_slot) {
    const bool is_far = dish_.distance(glm::vec3(a.center)) > static_cast<float>(a.shape->radius + margin);
    pair.contacts =
        is_far ? std::vector<Contact>{} : contacts_with(dish_, a, static_cast<float>(margin), pair.contacts);
    return;
  }
  const RigidBody& b = bodies_[pair.second];
  const float reach = std::min(a.shape->distance.reach(), b.shape->distance.reach());
  if (!boxes_near(a, b, reach)) {
    pair.contacts.clear();
    return;
  }

  // Two bodies that were farther apart than they have moved since are still apart.
  pair.clearance -= (a.travelled - pair.first_travelled) + (b.travelled - pair.second_travelled);
  pair.first_travelled = a.travelled;
  pair.second_travelled = b.travelled;
  if (pair.contacts.empty() && pair.clearance > a.speed + b.speed) return;
  const float near = std::min(static_cast<float>(margin + b.speed), reach);
  PairContacts contacts = contacts_between(a, b, near, pair.contacts);
  pair.contacts = std::move(contacts.contacts);
  pair.clearance = pair.contacts.empty() ? contacts.clearance - options_.contact_margin * unit_ : 0;
}

}  // namespace pomona
