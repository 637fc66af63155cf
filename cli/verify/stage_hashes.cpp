#include "cli/verify/stage_hashes.h"

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "generator/base/error.h"
#include "generator/base/sha256.h"
#include "generator/compose/grow.h"
#include "generator/cut/section/cross_section.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "generator/scene/scene.h"
#include "generator/surface/file/surface_file.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/ply.h"
#include "render/image/png.h"
#include "render/picture/section_picture.h"
#include "render/style/style_file.h"

namespace pomona {

namespace {

/// Collects numbers in the order of the calls.
class GatheredNumbers {
 public:
  void add(std::initializer_list<double> numbers) { all_.insert(all_.end(), numbers); }

  void add(const std::vector<double>& numbers) {
    all_.insert(all_.end(), numbers.begin(), numbers.end());
    add_count(numbers.size());
  }

  void add(const Curve& curve) {
    for (const glm::dvec2& point : curve.points) add({point.x, point.y});
    add_count(curve.points.size());
  }

  void add(const SurfaceSketch& surface) {
    add(surface.vertical);
    for (const Curve& curve : surface.horizontal) add(curve);
    add_count(surface.horizontal.size());
    if (surface.reference_azimuth) add({*surface.reference_azimuth});
    if (surface.reference) add({surface.reference->inner, surface.reference->outer});
    for (const auto& stop : surface.roundness.stops) add({stop.at, stop.value});
    add_count(surface.roundness.stops.size());
    add({surface.taper});
  }

  void add(const GrainSketch& grain) {
    const GrainForm& form = grain.form;
    add({grain.spacing.poisson_radius, form.length, form.width, form.thickness, form.pointedness});
    add({grain.stance.sink, grain.stance.angle, grain.stance.tilt, grain.ground.share, grain.ground.fold_share});
  }

  void add(const Individual& individual) {
    add({individual.ripeness, individual.browning});
    for (const ColorShift& shift : individual.shifts) add({shift.lightness, shift.chroma, shift.hue});
    add_count(individual.shifts.size());
  }

  const std::vector<double>& all() const { return all_; }

 private:
  void add_count(std::size_t count) { all_.push_back(static_cast<double>(count)); }

  std::vector<double> all_;
};

/// Curves, angles of folds, bend, proportions, sizes of grains, reference radii and shifts of colour, in the order of
/// the template's fields; after each list how many it has. Lengths in metres, angles in radians.
std::vector<double> variant_numbers(const Template& variant) {
  GatheredNumbers numbers;
  if (const auto* folds = std::get_if<FoldSymmetry>(&variant.symmetry)) numbers.add(folds->fold_angles);
  for (const SurfaceSketch& surface : variant.surfaces) numbers.add(surface);
  for (const GrainSketch& grain : variant.grains) numbers.add(grain);
  const AxisBend& bend = variant.bend;
  numbers.add({bend.angle, bend.swing, bend.direction});
  const Proportions& shape = variant.proportions;
  numbers.add({shape.slenderness, shape.pear, shape.barrel, shape.shoulders, shape.stretch});
  numbers.add(variant.individual);
  return numbers.all();
}

// Coarse fruit take a fraction of a second each.
constexpr double verified_detail = 0.3;
constexpr int verified_width = 240, verified_height = 180;

std::string first_digits(std::string_view bytes) { return sha256(bytes).substr(0, hash_digits); }

/// The bytes of the numbers in memory: little-endian, without gaps in the types used here.
template <typename Number>
std::string_view memory_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

std::string triangles_of(const CrossSection& section) {
  std::string bytes(memory_of(section.triangle));
  bytes += memory_of(section.cut);
  bytes += memory_of(section.part);
  bytes += memory_of(section.interior);
  return bytes;
}

std::string section_png(const CrossSection& section, const Template& fruit, const Style& style, Threads threads) {
  const Look look(fruit.noise, fruit.details);
  return write_png(draw_section(section, look, fruit.ink, style,
                                {.width = verified_width, .height = verified_height, .threads = threads}));
}

/// Nothing if the knife does not fit this fruit, as a peel thicker than a leaf.
std::optional<Slices> sliced_if_fit(const SliceTask& task, const Diffuser& diffuser, Threads threads) {
  try {
    return slice(task, &diffuser, {.cut = {.threads = threads}, .threads = threads});
  } catch (const Error& error) {
    if (error.status() != ExitStatus::usage) throw;
    return {};
  }
}

}  // namespace

std::vector<StageHashes> stage_hashes(const Template& drawn, std::uint64_t seed, std::span<const std::string> knives,
                                      Threads threads, const std::function<void()>& one_done) {
  const VariantKey key{seed, 0};
  const GrowOptions growing{.as_drawn = seed == 0, .detail = verified_detail, .threads = threads};
  const Template fruit = variant_of(drawn, key, growing);
  const std::string curves = first_digits(memory_of(variant_numbers(fruit)));
  const GrownFruit grown = grow(fruit, key, growing);
  const std::string surfaces = first_digits(write_surfaces(grown.sheets));
  const auto diffuser = make_pmvc_diffuser({Quality::draft, threads});
  const ExportOptions exported{.style = style_named("ink"), .threads = threads};

  std::vector<StageHashes> found;
  for (const std::string& words : knives) {
    const std::vector<Knife> knife{parse_knife(words)};
    if (one_done) one_done();
    std::optional<Slices> cut = sliced_if_fit(
        {.grown = grown, .variant = fruit, .knives = knife, .name = drawn.name, .origin = {.growing = growing}},
        *diffuser, threads);
    if (!cut) {
      found.push_back({curves, surfaces});
      continue;
    }
    Slices slices = std::move(*cut);
    const Scene scene = gathered(std::move(slices.pieces));
    found.push_back({curves, surfaces, first_digits(memory_of(slices.section.position)),
                     first_digits(triangles_of(slices.section)), first_digits(memory_of(slices.section.color)),
                     first_digits(write_solids(scene, exported)), first_digits(write_glb(scene, exported)),
                     first_digits(section_png(slices.styled, fruit, exported.style, threads))});
  }
  return found;
}

}  // namespace pomona
