#include "render/style/look.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "render/style/example.h"

namespace pomona {

namespace {

/// Weights below this change nothing that eight bits could show.
constexpr double min_weight = 1e-3;

/// How near a colour is to the `near` of a detail, 0..1.
/// \param unmodulated in OKLab
double nearness(const Look::Detail& detail, const glm::dvec3& unmodulated) {
  const DetailSketch& sketch = detail.pattern.detail();
  if (!sketch.near) return 1;
  const glm::dvec3 d = unmodulated - detail.near;
  return reproducible::exp(-glm::dot(d, d) / (2 * sketch.near_within * sketch.near_within));
}

/// The weight of a detail for a colour.
double weight_of(const Look::Detail& detail, const glm::dvec3& unmodulated, double share) {
  const double weight = detail.pattern.detail().amount * share;
  return std::fabs(weight) < min_weight ? weight : weight * nearness(detail, unmodulated);
}

}  // namespace

Look::Look(const NoiseStyle& noise, const std::vector<DetailSketch>& details, const Look* like) : modulation_(noise) {
  for (const DetailSketch& sketch : details) {
    std::vector<Detail>& of_face = details_[static_cast<std::size_t>(sketch.face)];
    if (of_face.size() == static_cast<std::size_t>(max_details_of_a_face)) continue;
    const Pattern* known = nullptr;
    if (like != nullptr) {
      const std::vector<Detail>& others = like->details(sketch.face);
      if (of_face.size() < others.size()) known = &others[of_face.size()].pattern;
    }
    Detail detail{Pattern(sketch, static_cast<std::uint32_t>(&sketch - details.data()), known),
                  sketch.color ? glm::dvec3(to_oklab(*sketch.color)) : glm::dvec3(sketch.axis), glm::dvec3(0)};
    if (sketch.near) detail.near = to_oklab(*sketch.near);
    has_examples_ = has_examples_ || sketch.tile != nullptr;
    of_face.push_back(detail);
  }
}

Look::Height Look::height(const Color& unmodulated, const LookPlace& place) const {
  Height sum;
  std::optional<glm::dvec3> plain;
  const std::vector<Detail>& details = this->details(place.face);
  for (std::size_t i = 0; i < details.size(); ++i) {
    const DetailSketch& sketch = details[i].pattern.detail();
    double relief = sketch.relief * static_cast<double>(place.guide.share[static_cast<int>(i)]);
    if (relief == 0) continue;
    if (sketch.near && !plain) plain = to_oklab(unmodulated);
    if (sketch.near) relief *= nearness(details[i], *plain);
    const double share = details[i].pattern(place.position, place.guide, place.footprint).share;
    sum.height += relief * share;
    sum.below += std::max(relief * (details[i].pattern.shape().mean.share - share), 0.0) / sketch.size;
  }
  return sum;
}

bool Look::has_relief(DetailFace face) const {
  const std::vector<Detail>& of_face = details(face);
  return std::any_of(of_face.begin(), of_face.end(),
                     [](const Detail& detail) { return detail.pattern.detail().relief != 0; });
}

bool Look::is_plain() const { return modulation_.bands() == 0 && details_[0].empty() && details_[1].empty(); }

/// Tiles add in linear light, so that the mean of the colours stays as they are diffused.
Color Look::with_examples(const Color& modulated, const Color& unmodulated, const LookPlace& place) const {
  const std::vector<Detail>& details = this->details(place.face);
  Color color = modulated;
  for (std::size_t i = 0; i < details.size(); ++i) {
    const ExampleTile* const tile = details[i].pattern.detail().tile.get();
    const double given = static_cast<double>(place.guide.share[static_cast<int>(i)]);
    if (tile == nullptr || given == 0) continue;
    const bool is_anywhere = !details[i].pattern.detail().near;
    const double weight = weight_of(details[i], is_anywhere ? glm::dvec3(0) : glm::dvec3(to_oklab(unmodulated)), given);
    if (weight < min_weight) continue;
    color = with_example(color, *tile, details[i].pattern(place.position, place.guide, place.footprint).shown, weight);
  }
  return color;
}

Color Look::operator()(const Color& unmodulated, const LookPlace& place) const {
  // Noise first; without a guide that is all.
  Color modulated = modulation_(unmodulated, place.position, place.footprint);
  const glm::vec4& share = place.guide.share;
  if (share == glm::vec4(0)) return modulated;

  // Then the examples, in linear light, and the other details in their order. OKLab is worked out only once a detail
  // needs it.
  if (has_examples_) modulated = with_examples(modulated, unmodulated, place);
  const std::vector<Detail>& details = this->details(place.face);
  std::optional<glm::dvec3> plain, lab;
  for (std::size_t i = 0; i < details.size(); ++i) {
    const double given = static_cast<double>(share[static_cast<int>(i)]);
    if (given == 0 || details[i].pattern.detail().tile) continue;
    if (!plain) plain = to_oklab(unmodulated);
    const double weight = weight_of(details[i], *plain, given);
    if (std::fabs(weight) < min_weight) continue;
    if (!lab) lab = to_oklab(modulated);
    const PatternValue value = details[i].pattern(place.position, place.guide, place.footprint);
    const glm::dvec3 way = details[i].pattern.detail().color ? details[i].target - *lab : details[i].target;
    *lab += value.share * weight * way;
    lab->x += value.tone * std::fabs(weight) * tone_step;
  }

  // Colours without any such detail keep the bits that they have.
  if (!lab) return modulated;
  const Color result = from_oklab(glm::vec3(*lab));
  return {std::clamp(result.r, 0.0f, 1.0f), std::clamp(result.g, 0.0f, 1.0f), std::clamp(result.b, 0.0f, 1.0f)};
}

}  // namespace pomona
