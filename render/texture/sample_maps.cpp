#include "render/texture/sample_maps.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "generator/base/gradient_noise.h"
#include "generator/cut/section/guide_lattice.h"
#include "render/style/pbr_roughness.h"
#include "render/texture/maps.h"

namespace pomona {

namespace {

constexpr std::size_t samples_at_once = 512;  // the looks of their corners fit the processor's caches

// The film of juice on a wet face swells by some millimetres, as in pictures (shaders/lit.glsl), and is uneven.
constexpr double film_frequency = 95;  // cycles per metre
constexpr double film_uneven = 0.35;   // variation of the roughness, as a share
constexpr std::uint32_t film_seed = 411;

constexpr double closed_in_pit = 0.6;  // share of the light from all sides that is lost in the middle of a pit

glm::dvec3 unit_of(const glm::dvec3& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 1e-30 ? v / length : glm::dvec3(0, 1, 0);
}

template <typename Value>
Value at_weights(const std::vector<Value>& values, const glm::uvec3& v, const glm::dvec3& weight) {
  return values[v.x] * static_cast<float>(weight.x) + values[v.y] * static_cast<float>(weight.y) +
         values[v.z] * static_cast<float>(weight.z);
}

}  // namespace

SampleMaps::SampleMaps(const Solid& solid, const Look& look, const TangentMesh& mesh, double texel, Threads threads)
    : solid_(solid),
      look_(look),
      mesh_(mesh),
      faces_(solid),
      pits_(solid),
      shine_(solid),
      texel_(texel),
      threads_(threads) {
  for (std::size_t part = 0; part < std::max<std::size_t>(solid.look->part_names.size(), 1); ++part) {
    const MaterialSketch material = material_of(solid, static_cast<std::int32_t>(part));
    of_part_.push_back({shows_rim(material), solid.look->materials.empty() ? 0 : material.wet});
  }
}

std::vector<MapSample> SampleMaps::of(const std::vector<TexelSample>& samples, const std::vector<Color>& plain) const {
  std::vector<MapSample> made(samples.size());
  parallel_for((samples.size() + samples_at_once - 1) / samples_at_once, threads_, [&](std::size_t chunk) {
    const std::size_t end = std::min(samples.size(), (chunk + 1) * samples_at_once);
    const std::size_t first = chunk * samples_at_once;
    std::vector<LookPlace> places;
    std::vector<glm::dvec3> normals;
    for (std::size_t i = first; i < end; ++i) {
      places.push_back(look_place(samples[i], solid_.mesh.place(samples[i].triangle, samples[i].weight)));
      normals.push_back(normal_at(samples[i]));
    }
    const std::vector<Relief> reliefs =
        reliefs_over_texels(look_, std::span(plain).subspan(first, end - first), places, normals);
    for (std::size_t i = first; i < end; ++i)
      made[i] = at(samples[i], places[i - first].position, normals[i - first], reliefs[i - first]);
  });
  return made;
}

MapSample SampleMaps::speck(std::uint32_t triangle) const {
  MapSample level;
  const glm::dvec3 place(solid_.mesh.position[solid_.mesh.triangle[triangle].x]);
  const PlaceShine shine = shine_.at(triangle, {1, 0, 0});
  level.orm.y = static_cast<float>(roughness(triangle, shine.roughness, place));
  level.thickness.x = static_cast<float>(shine.film);
  return level;
}

glm::dvec3 SampleMaps::normal_at(const TexelSample& sample) const {
  const glm::uvec3& v = solid_.mesh.triangle[sample.triangle];
  return unit_of(glm::dvec3(at_weights(solid_.mesh.normal, v, sample.weight)));
}

MapSample SampleMaps::at(const TexelSample& sample, const glm::dvec3& place, const glm::dvec3& normal,
                         const Relief& relief) const {
  const bool cut = solid_.mesh.cut_face[sample.triangle] >= 0;
  const RimPlace rim = cut ? faces_.at(sample.triangle, place) : RimPlace{};
  const bool lies_in_pit = cut || material_of(solid_, part(sample)).pit > 0;
  const PitPlace pit = lies_in_pit ? PitPlace{} : pits_.at(place, normal);

  // Level places are level to the bit.
  MapSample made;
  const glm::dvec3 slope = relief.slope + rim.slope + pit.slope;
  if (slope != glm::dvec3(0)) {
    const glm::dvec3 along(
        glm::vec3(at_weights(mesh_.tangent, mesh_.triangle[mesh_.number[sample.triangle]], sample.weight)));
    const glm::dvec3 right = unit_of(along - normal * glm::dot(along, normal)), up = glm::cross(normal, right);
    const glm::dvec3 bumped = tilted(normal, slope - normal * glm::dot(slope, normal));
    made.normal = glm::vec3(glm::dot(bumped, right), glm::dot(bumped, up), glm::dot(bumped, normal));
  }
  const PlaceShine shine = shine_.at(sample.triangle, sample.weight);
  made.orm = {relief.open * (1 - closed_in_pit * pit.inside), roughness(sample.triangle, shine.roughness, place), 0};
  made.thickness.x = static_cast<float>(shine.film);
  const auto part_number = static_cast<std::size_t>(std::max(part(sample), 0));
  const bool thin_at_rim = cut && part_number < of_part_.size() && of_part_[part_number].shows_rim;
  if (thin_at_rim) made.thickness.y = static_cast<float>(std::min(1.0, (0.0005 + 2 * rim.rim) / max_thickness));
  return made;
}

LookPlace SampleMaps::look_place(const TexelSample& sample, const glm::dvec3& place) const {
  LookPlace seen{.position = place, .footprint = texel_};
  if (solid_.mesh.cut_face[sample.triangle] < 0) seen.face = DetailFace::skin;
  if (solid_.mesh.guide.empty()) return seen;
  const glm::uvec3& v = solid_.mesh.triangle[sample.triangle];
  seen.guide = interpolated(solid_.mesh.guide[v.x], solid_.mesh.guide[v.y], solid_.mesh.guide[v.z],
                            static_cast<float>(sample.weight.y), static_cast<float>(sample.weight.z));
  if (seen.face == DetailFace::cut) seen.guide = guide_at(solid_.mesh.guide_lattice.get(), place, seen.guide);
  return seen;
}

double SampleMaps::roughness(std::uint32_t triangle, double own, const glm::dvec3& place) const {
  const std::int32_t part = solid_.mesh.part[solid_.mesh.triangle[triangle].x];
  const auto number = static_cast<std::size_t>(std::max(part, 0));
  if (number >= of_part_.size()) return pbr_dull;
  const bool cut = solid_.mesh.cut_face[triangle] >= 0;
  const double film = cut ? std::clamp((of_part_[number].wet - 0.3) / 0.9, 0.0, 1.0) : 0;
  if (film == 0) return own;
  return std::clamp(own * (1 + film * film_uneven * gradient_noise(place * film_frequency, film_seed)), 0.05, 1.0);
}

}  // namespace pomona
