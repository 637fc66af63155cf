#include "generator/scene/settle/heap.h"

#include <algorithm>

namespace pomona {

namespace {

bool boxes_near(const RigidBody& a, const RigidBody& b, float reach) {
  return Box<float>{a.box.low - reach, a.box.high + reach}.meets(b.box);
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

}  // namespace pomona
