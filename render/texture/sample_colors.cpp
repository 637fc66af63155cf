#include "render/texture/sample_colors.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "generator/cut/section/guide_lattice.h"

namespace pomona {

namespace {

constexpr std::size_t chunk_size = 1024;  // samples; their looks fit the processor's caches

std::size_t chunks(std::size_t count) { return (count + chunk_size - 1) / chunk_size; }

template <typename Visit>
void for_chunk(std::size_t chunk, std::size_t count, const Visit& visit) {
  for (std::size_t i = chunk * chunk_size; i < std::min(count, (chunk + 1) * chunk_size); ++i) visit(i);
}

}  // namespace

SampleColors::SampleColors(const Solid& solid, const Style& style, const OfCutFaces& of_cut_faces, double texel,
                           Threads threads)
    : mesh_(solid.mesh),
      of_cut_faces_(of_cut_faces),
      look_(style.noise ? Look(solid.look->noise, solid.look->details) : Look()),
      paint_(style),
      texel_(texel),
      threads_(threads) {}

std::vector<Color> SampleColors::plain(const std::vector<TexelSample>& samples) {
  std::vector<Color> colors(samples.size());
  std::vector<glm::vec3> points(samples.size());
  parallel_for(chunks(samples.size()), threads_, [&](std::size_t chunk) {
    for_chunk(chunk, samples.size(), [&](std::size_t i) {
      points[i] = glm::vec3(mesh_.place(samples[i].triangle, samples[i].weight));
      colors[i] = interpolated(samples[i]);
    });
  });
  diffuse(samples, points, colors);
  return colors;
}

std::vector<Color> SampleColors::styled(const std::vector<TexelSample>& samples, std::vector<Color> colors) const {
  if (look_.is_plain() && paint_.is_plain()) return colors;
  parallel_for(chunks(samples.size()), threads_, [&](std::size_t chunk) {
    std::vector<LookPlace> places;
    for_chunk(chunk, samples.size(), [&](std::size_t i) { places.push_back(look_place(samples[i])); });
    const std::span<Color> own = std::span(colors).subspan(chunk * chunk_size, places.size());
    const std::vector<Color> seen = look_(own, places);
    for (std::size_t i = 0; i < seen.size(); ++i) own[i] = paint_(seen[i]);
  });
  return colors;
}

Color SampleColors::mean_of(const Chart& chart) const {
  glm::dvec3 sum(0), place(0);
  double area = 0;
  for (const std::uint32_t t : chart.triangles) {
    const glm::uvec3& v = mesh_.triangle[t];
    const auto [a, b, c] = mesh_.corners(t);
    const glm::dvec3 n = mesh_.area_vector(t);
    const double weight = std::sqrt(glm::dot(n, n)) + 1e-30;
    sum += weight * glm::dvec3(mesh_.color[v.x] + mesh_.color[v.y] + mesh_.color[v.z]) / 3.0;
    place += weight * (a + b + c) / 3.0;
    area += weight;
  }
  const std::uint32_t first = chart.triangles.front();
  LookPlace seen = look_place({.texel = {}, .triangle = first, .weight = glm::dvec3(1 / 3.), .outside = false});
  seen.position = place / area;
  return paint_(look_(Color(sum / area), seen));
}

LookPlace SampleColors::look_place(const TexelSample& sample) const {
  const glm::uvec3& v = mesh_.triangle[sample.triangle];
  LookPlace seen{.position = mesh_.place(sample.triangle, sample.weight), .footprint = texel_};
  if (mesh_.cut_face[sample.triangle] < 0) seen.face = DetailFace::skin;
  if (mesh_.guide.empty()) return seen;
  seen.guide = pomona::interpolated(mesh_.guide[v.x], mesh_.guide[v.y], mesh_.guide[v.z],
                                    static_cast<float>(sample.weight.y), static_cast<float>(sample.weight.z));
  if (seen.face == DetailFace::cut) seen.guide = guide_at(mesh_.guide_lattice.get(), seen.position, seen.guide);
  return seen;
}

/// Interpolates between vertices on skin and on the rim of a cut face, whose vertices have the colours of their
/// surfaces; elsewhere on cut faces between diffused points.
Color SampleColors::interpolated(const TexelSample& sample) const {
  const bool within_face = !sample.outside && mesh_.cut_face[sample.triangle] >= 0;
  if (of_cut_faces_.faces != nullptr && within_face) return of_cut_faces_.faces->at(sample.triangle, sample.weight);

  const glm::uvec3& v = mesh_.triangle[sample.triangle];
  return Color(sample.weight.x * glm::dvec3(mesh_.color[v.x]) + sample.weight.y * glm::dvec3(mesh_.color[v.y]) +
               sample.weight.z * glm::dvec3(mesh_.color[v.z]));
}

void SampleColors::diffuse(const std::vector<TexelSample>& samples, const std::vector<glm::vec3>& points,
                           std::vector<Color>& colors) {
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; of_cut_faces_.field != nullptr && i < samples.size(); ++i) {
    if (!samples[i].outside && mesh_.cut_face[samples[i].triangle] >= 0) wanted.push_back(i);
  }
  for (std::size_t first = 0; first < wanted.size(); first += at_once) {
    std::vector<glm::vec3> at;
    const std::size_t end = std::min(wanted.size(), first + at_once);
    for (std::size_t i = first; i < end; ++i) at.push_back(points[wanted[i]]);
    const DiffusedColors found = of_cut_faces_.field->at(at);
    for (std::size_t i = first; i < end; ++i) colors[wanted[i]] = found.color[i - first];
  }
  diffused_ += wanted.size();
}

}  // namespace pomona
