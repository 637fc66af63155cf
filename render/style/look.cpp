#include "render/style/look.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>

#include "generator/base/many_values.h"
#include "render/style/example.h"

namespace pomona {

namespace {

/// Weights below this change nothing that eight bits could show.
constexpr double min_weight = 1e-3;

/// A detail at the places where it counts, each with a weight, as numbers of the places.
struct DetailPlaces {
  std::vector<std::size_t> at;
  std::vector<double> weight;
};

/// Multiplies the weights by how near colours are to the `near` of a detail, 0..1.
/// \param unmodulated in OKLab, of all places
void weigh_by_nearness(const Look::Detail& detail, const std::vector<glm::vec3>& unmodulated, DetailPlaces& places) {
  const DetailSketch& sketch = detail.pattern.detail();
  if (!sketch.near) return;
  std::vector<double> exponent;
  exponent.reserve(places.at.size());
  for (const std::size_t i : places.at) {
    const glm::dvec3 d = glm::dvec3(unmodulated[i]) - detail.near;
    exponent.push_back(-glm::dot(d, d) / (2 * sketch.near_within * sketch.near_within));
  }
  const std::vector<double> nearness = reproducible::exponentials(exponent);
  for (std::size_t i = 0; i < nearness.size(); ++i) places.weight[i] *= nearness[i];
}

void leave_out_light_ones(DetailPlaces& places) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.at.size(); ++i) {
    if (std::fabs(places.weight[i]) < min_weight) continue;
    places.at[kept] = places.at[i], places.weight[kept++] = places.weight[i];
  }
  places.at.resize(kept), places.weight.resize(kept);
}

/// The places of one kind of face where the detail `number` has a share, with that share times `amount` as weight.
DetailPlaces shared_places(std::span<const LookPlace> places, DetailFace face, int number, double amount) {
  DetailPlaces found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double given = static_cast<double>(places[i].guide.share[number]);
    if (places[i].face == face && given != 0) found.at.push_back(i), found.weight.push_back(amount * given);
  }
  return found;
}

std::vector<PatternValue> pattern_at(const Pattern& pattern, std::span<const LookPlace> places,
                                     const DetailPlaces& wanted) {
  std::vector<PatternSpot> spots;
  spots.reserve(wanted.at.size());
  for (const std::size_t i : wanted.at) spots.push_back({places[i].position, places[i].guide, places[i].footprint});
  return pattern(spots);
}

constexpr std::array<DetailFace, 2> faces = {DetailFace::cut, DetailFace::skin};

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
    of_face.push_back(detail);
  }
}

Look::Height Look::height(const Color& unmodulated, const LookPlace& place) const {
  return height({&unmodulated, 1}, {&place, 1}).front();
}

std::vector<Look::Height> Look::height(std::span<const Color> unmodulated, std::span<const LookPlace> places) const {
  std::vector<Height> sum(places.size());
  std::vector<glm::vec3> plain;
  for (const DetailFace face : faces) {
    const std::vector<Detail>& details = this->details(face);
    for (std::size_t n = 0; n < details.size(); ++n) {
      const DetailSketch& sketch = details[n].pattern.detail();
      if (sketch.relief == 0) continue;
      DetailPlaces high = shared_places(places, face, static_cast<int>(n), sketch.relief);
      if (high.at.empty()) continue;
      if (sketch.near && plain.empty()) plain = to_oklab(unmodulated);
      weigh_by_nearness(details[n], plain, high);
      const std::vector<PatternValue> value = pattern_at(details[n].pattern, places, high);
      const double mean = details[n].pattern.shape().mean.share;
      for (std::size_t i = 0; i < value.size(); ++i) {
        sum[high.at[i]].height += high.weight[i] * value[i].share;
        sum[high.at[i]].below += std::max(high.weight[i] * (mean - value[i].share), 0.0) / sketch.size;
      }
    }
  }
  return sum;
}

bool Look::has_relief(DetailFace face) const {
  const std::vector<Detail>& of_face = details(face);
  return std::any_of(of_face.begin(), of_face.end(),
                     [](const Detail& detail) { return detail.pattern.detail().relief != 0; });
}

bool Look::is_plain() const { return modulation_.bands() == 0 && details_[0].empty() && details_[1].empty(); }

namespace {

/// What details do with the colours of many places, one detail after another.
class DetailedColors {
 public:
  DetailedColors(std::span<const Color> unmodulated, std::span<const LookPlace> places, std::vector<Color>& colors)
      : unmodulated_(unmodulated), places_(places), colors_(colors) {}

  /// Tiles add in linear light, so that the mean of the colours stays as they are diffused.
  void add_example(const Look::Detail& detail, const DetailPlaces& at) {
    const std::vector<PatternValue> value = pattern_at(detail.pattern, places_, at);
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (at.weight[i] < min_weight) continue;
      Color& color = colors_[at.at[i]];
      color = with_example(color, *detail.pattern.detail().tile, value[i].shown, at.weight[i]);
    }
  }

  void add(const Look::Detail& detail, const DetailPlaces& at) {
    if (at.at.empty()) return;
    start_labs();
    const std::vector<PatternValue> value = pattern_at(detail.pattern, places_, at);
    for (std::size_t i = 0; i < value.size(); ++i) {
      glm::dvec3& lab = lab_[at.at[i]];
      const glm::dvec3 way = detail.pattern.detail().color ? detail.target - lab : detail.target;
      lab += value[i].share * at.weight[i] * way;
      lab.x += value[i].tone * std::fabs(at.weight[i]) * Look::tone_step;
      is_moved_[at.at[i]] = 1;
    }
  }

  /// OKLab before noise and details. \param detail the one that asks
  const std::vector<glm::vec3>& plain_for(const Look::Detail& detail) {
    if (detail.pattern.detail().near && plain_.empty()) plain_ = to_oklab(unmodulated_);
    return plain_;
  }

  /// Colours without any such detail keep the bits that they have.
  void finish() {
    for (std::size_t i = 0; i < lab_.size(); ++i)
      if (is_moved_[i] != 0) colors_[i] = from_oklab_within_gamut(glm::vec3(lab_[i]));
  }

 private:
  /// OKLab is worked out only once a detail needs it.
  void start_labs() {
    if (!lab_.empty()) return;
    for (const glm::vec3& lab : to_oklab(colors_)) lab_.emplace_back(lab);
    is_moved_.assign(lab_.size(), 0);
  }

  std::span<const Color> unmodulated_;
  std::span<const LookPlace> places_;
  std::vector<Color>& colors_;
  std::vector<glm::vec3> plain_;
  std::vector<glm::dvec3> lab_;
  std::vector<std::uint8_t> is_moved_;
};

}  // namespace

Color Look::operator()(const Color& unmodulated, const LookPlace& place) const {
  return (*this)({&unmodulated, 1}, {&place, 1}).front();
}

std::vector<Color> Look::operator()(std::span<const Color> unmodulated, std::span<const LookPlace> places) const {
  std::vector<glm::dvec3> positions;
  std::vector<double> footprints;
  for (const LookPlace& place : places) positions.push_back(place.position), footprints.push_back(place.footprint);
  std::vector<Color> colors = modulation_(unmodulated, positions, footprints);

  // Noise first; then the examples, in linear light, and the other details in their order.
  DetailedColors detailed(unmodulated, places, colors);
  for (const bool by_example : {true, false}) {
    for (const DetailFace face : faces) {
      const std::vector<Detail>& details = this->details(face);
      for (std::size_t n = 0; n < details.size(); ++n) {
        const DetailSketch& sketch = details[n].pattern.detail();
        if ((sketch.tile != nullptr) != by_example) continue;
        DetailPlaces at = shared_places(places, face, static_cast<int>(n), sketch.amount);
        leave_out_light_ones(at);
        if (at.at.empty()) continue;
        weigh_by_nearness(details[n], detailed.plain_for(details[n]), at);
        leave_out_light_ones(at);
        by_example ? detailed.add_example(details[n], at) : detailed.add(details[n], at);
      }
    }
  }
  detailed.finish();
  return colors;
}

}  // namespace pomona
