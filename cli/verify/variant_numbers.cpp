#include "cli/verify/variant_numbers.h"

#include <initializer_list>
#include <variant>

namespace pomona {

namespace {

/// Gathers numbers in the order in which they are named.
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

}  // namespace

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

}  // namespace pomona
