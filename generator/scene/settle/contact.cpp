#include "generator/scene/settle/contact.h"

#include <algorithm>
#include <array>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pomona {

namespace {

/// A sample that is near. The point is in the frame of the distance field.
struct Candidate {
  glm::vec3 point;
  float distance;
  int sample;
};

/// The transform from one body's frame to another's.
struct Frame {
  glm::mat3 turn{1};
  glm::vec3 move{0};
  glm::vec3 operator()(const glm::vec3& p) const { return turn * p + move; }
};

Frame seen_from(const RigidBody& b, const RigidBody& a) {
  const glm::mat3 back = glm::transpose(b.matrix);
  return {back * a.matrix, back * glm::vec3(a.center - b.center)};
}

/// Visits all samples with a distance below `margin`; skips balls of samples that are farther away. Returns a lower
/// bound of the distance of all samples.
template <typename Field, typename Visit>
float search(const SurfaceSamples& samples, const Frame& frame, const Field& field, float margin, const Visit& visit) {
  float bound = std::numeric_limits<float>::max();
  const int count = static_cast<int>(samples.ball.size());
  for (int k = 0; k < count;) {
    const SampleBall& ball = samples.ball[static_cast<std::size_t>(k)];
    const float nearest = field(frame(ball.center)) - ball.radius;
    if (nearest > margin) {
      bound = std::min(bound, nearest);
      k = ball.after;
      continue;
    }
    ++k;
    for (int i = ball.first; i < ball.first + ball.count; ++i) {
      const glm::vec3 point = frame(samples.point[static_cast<std::size_t>(i)]);
      const float distance = field(point);
      bound = std::min(bound, distance);
      if (distance < margin) visit(Candidate{point, distance, i});
    }
  }
  return bound;
}

struct Search {
  std::vector<Candidate> found;
  float bound = 0;
};

template <typename Field>
Search near_samples(const SurfaceSamples& samples, const Frame& frame, const Field& field, float margin) {
  Search search_;
  search_.bound = search(samples, frame, field, margin, [&](const Candidate& c) { search_.found.push_back(c); });
  return search_;
}

float squared_distance(const glm::vec3& a, const glm::vec3& b) { return glm::dot(a - b, a - b); }

/// Candidates spread over the contact area: the deepest first, then again and again the one that is farthest from those
/// chosen. Deeper candidates and those of the last step get a larger weight. `sample_of` gives a candidate's number as
/// in Contact::sample.
template <typename SampleOf>
std::vector<Candidate> spread_out(const std::vector<Candidate>& from, std::size_t max_count, float margin,
                                  const std::vector<Contact>& before, const SampleOf& sample_of) {
  if (from.empty()) return {};
  const auto deepest =
      std::min_element(from.begin(), from.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const float range = std::max(1e-9f, margin - deepest->distance);
  std::vector<float> weight(from.size()), away(from.size(), std::numeric_limits<float>::max());
  for (std::size_t i = 0; i < from.size(); ++i) {
    weight[i] = std::max(0.02f, (margin - from[i].distance) / range);
    for (const Contact& contact : before)
      if (contact.sample == sample_of(from[i])) weight[i] *= 1.6f;
  }

  constexpr float same_place = 4e-8f;  // square metres: 0.2 mm
  std::vector<Candidate> result{*deepest};
  while (result.size() < max_count) {
    std::size_t next = 0;
    float best = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      away[i] = std::min(away[i], squared_distance(from[i].point, result.back().point));
      if (away[i] * weight[i] > best) best = away[i] * weight[i], next = i;
    }
    if (best == 0 || away[next] < same_place) break;
    result.push_back(from[next]);
  }
  return result;
}

/// Copies the impulse that the same contact had a step before.
void inherit_impulses(std::vector<Contact>& contacts, const std::vector<Contact>& before) {
  for (Contact& contact : contacts) {
    const auto same =
        std::find_if(before.begin(), before.end(), [&](const Contact& old) { return old.sample == contact.sample; });
    if (same == before.end()) continue;
    contact.impulse = same->impulse;
    contact.is_persistent = true;
  }
}

}  // namespace

PairContacts contacts_between(const RigidBody& a, const RigidBody& b, float margin,
                              const std::vector<Contact>& before) {
  constexpr int second_body = 1 << 20;  // marks the samples of the second body
  PairContacts result;
  result.clearance = std::numeric_limits<float>::max();
  for (const bool second : {false, true}) {
    const RigidBody &sampled = second ? b : a, &measured = second ? a : b;
    const DistanceGrid& grid = measured.shape->distance;
    const auto field = [&](const glm::vec3& p) { return grid.value(p); };
    const Search search = near_samples(sampled.shape->samples, seen_from(measured, sampled), field, margin);
    result.clearance = std::min(result.clearance, search.bound);

    const auto sample_of = [&](const Candidate& c) { return c.sample + (second ? second_body : 0); };
    for (const Candidate& c : spread_out(search.found, 4, margin, before, sample_of)) {
      const glm::vec3 off = measured.matrix * grid.direction(c.point);
      const glm::vec3 point = measured.matrix * c.point + glm::vec3(measured.center);
      result.contacts.push_back({sample_of(c), point, second ? -off : off, c.distance});
    }
  }
  inherit_impulses(result.contacts, before);
  return result;
}

std::vector<Contact> contacts_with(const Dish& dish, const RigidBody& body, float margin,
                                   const std::vector<Contact>& before) {
  const Frame frame{body.matrix, glm::vec3(body.center)};
  const auto field = [&](const glm::vec3& p) { return dish.distance(p); };
  const Search search = near_samples(body.shape->samples, frame, field, margin);
  std::vector<Contact> contacts;
  for (const Candidate& c : spread_out(search.found, 6, margin, before, [](const Candidate& k) { return k.sample; }))
    contacts.push_back({c.sample, c.point, dish.direction(c.point), c.distance});
  inherit_impulses(contacts, before);
  return contacts;
}

float distance_between(const RigidBody& a, const RigidBody& b, float within) {
  float nearest = within;
  const auto keep = [&](const Candidate& c) { nearest = std::min(nearest, c.distance); };
  search(
      a.shape->samples, seen_from(b, a), [&](const auto& p) { return b.shape->distance.value(p); }, within, keep);
  search(
      b.shape->samples, seen_from(a, b), [&](const auto& p) { return a.shape->distance.value(p); }, within, keep);
  return nearest;
}

float distance_to(const Dish& dish, const RigidBody& body, float within) {
  float nearest = within;
  const Frame frame{body.matrix, glm::vec3(body.center)};
  search(
      body.shape->samples, frame, [&](const auto& p) { return dish.distance(p); }, within,
      [&](const Candidate& c) { nearest = std::min(nearest, c.distance); });
  return nearest;
}

}  // namespace pomona
