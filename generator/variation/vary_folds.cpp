#include "generator/variation/vary_folds.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "generator/base/units.h"
#include "generator/variation/fold_draw.h"
#include "generator/variation/fold_pca.h"
#include "generator/variation/fold_room.h"
#include "generator/variation/fold_samples.h"
#include "generator/variation/half_turn.h"
#include "generator/variation/vary_counts.h"

namespace pomona {

namespace {

/// The properties that all drawn samples of a surface share, and that a blend must have.
class FoldForm {
 public:
  explicit FoldForm(const FoldSamples& drawn);

  /// True if the curve, in the pie-shaped space, does not meet itself, stays between the fold lines (at least half as
  /// far from them as drawn), does not come near the axis, and, if closed, still runs counter-clockwise. True for an
  /// empty one.
  bool is_kept(const PolarCurve& fold) const;

 private:
  bool closed_ = false;
  bool simple_ = true;     ///< true if all samples are simple
  double margin_ = 0;      ///< least distance from a fold line, as a share of the fold; closed loops only
  double min_radius_ = 0;  ///< metres
  double pie_ = 1;         ///< angle of the pie, radians
};

Curve in_pie(const PolarCurve& fold, double pie, bool closed) {
  PolarCurve placed = fold;
  for (double& azimuth : placed.azimuth) azimuth *= pie;
  return from_polar(placed, closed);
}

/// The distance of the curve from the fold lines; of open curves without their ends, which lie on them.
double distance_from_lines(const PolarCurve& fold, bool closed) {
  const std::ptrdiff_t ends = closed ? 0 : 1;
  const auto [min, max] = std::minmax_element(fold.azimuth.begin() + ends, fold.azimuth.end() - ends);
  return std::min(*min, 1 - *max);
}

double min_radius(const PolarCurve& fold) { return *std::min_element(fold.radius.begin(), fold.radius.end()); }

FoldForm::FoldForm(const FoldSamples& drawn) : closed_(drawn.closed), margin_(1), min_radius_(1e9) {
  // The crossings are the same for any angle below a whole turn.
  pie_ = std::min(2 * pi / static_cast<double>(drawn.fold.size()), pi);
  for (const PolarCurve& fold : drawn.fold) {
    if (fold.size() == 0) continue;
    simple_ = simple_ && is_simple(in_pie(fold, pie_, closed_));
    margin_ = std::min(margin_, distance_from_lines(fold, closed_));
    min_radius_ = std::min(min_radius_, min_radius(fold));
  }
}

bool FoldForm::is_kept(const PolarCurve& fold) const {
  if (fold.size() == 0) return true;
  if (min_radius(fold) < 0.2 * min_radius_) return false;
  if (margin_ > 0 && distance_from_lines(fold, closed_) <= (closed_ ? 0.5 * margin_ : 0)) return false;
  const Curve curve = in_pie(fold, pie_, closed_);
  if (closed_ && !(signed_area(curve) > 0)) return false;
  return !simple_ || is_simple(curve);
}

std::vector<bool> presence(const FoldSamples& samples) {
  std::vector<bool> present;
  for (const PolarCurve& fold : samples.fold) present.push_back(fold.size() > 0);
  return present;
}

/// Blended widths, limited to 0.5 to 1.5 times the drawn ones.
std::vector<double> blended_widths(const std::vector<double>& drawn, const std::vector<FoldDraw>& draws) {
  const auto [min, max] = std::minmax_element(drawn.begin(), drawn.end());
  std::vector<double> widths;
  double total = 0;
  for (const FoldDraw& draw : draws) {
    const std::vector<double> c = coefficients(draw, std::vector<bool>(drawn.size(), true));
    double width = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) width += c[i] * drawn[i];
    widths.push_back(std::clamp(width, 0.5 * *min, 1.5 * *max));
    total += widths.back();
  }
  for (double& width : widths) width *= 2 * pi / total;
  return widths;
}

FoldSymmetry symmetry_of(double first, const std::vector<double>& widths) {
  FoldSymmetry symmetry{{first}};
  for (std::size_t k = 0; k + 1 < widths.size(); ++k) {
    symmetry.fold_angles.push_back(symmetry.fold_angles.back() + widths[k]);
  }
  return symmetry;
}

/// Maps from the pie-shaped space back to the fruit.
PolarCurve placed(PolarCurve sample, double from, double width) {
  for (double& azimuth : sample.azimuth) azimuth = from + azimuth * width;
  return sample;
}

/// Blends the folds of one surface: a sample for each fold of the variant, empty where the fold has none.
/// \param bearing whether the fold has the surface; a fold that has stepped down to a drawn fold without it does not.
std::vector<PolarCurve> blended_folds(const FoldSamples& samples, const std::vector<FoldDraw>& draws,
                                      const std::vector<bool>& bearing) {
  const std::vector<bool> present = presence(samples);
  std::vector<PolarCurve> folds;
  for (std::size_t k = 0; k < draws.size(); ++k) {
    const FoldDraw& draw = draws[k];
    const bool here = bearing[k] && (present[draw.source] || draw.rung < FoldDraw::drawn_rung);
    folds.push_back(here ? blended(samples.fold, coefficients(draw, present)) : PolarCurve{});
  }
  if (!samples.closed) join(folds);
  return folds;
}

/// One loop around the axis, or one in each fold.
std::vector<Curve> loops_of(const std::vector<PolarCurve>& folds, const FoldSymmetry& symmetry,
                            const std::vector<double>& widths, bool closed) {
  std::vector<Curve> loops;
  Curve around;
  around.closed = true;
  for (std::size_t k = 0; k < folds.size(); ++k) {
    Curve fold = from_polar(placed(folds[k], symmetry.fold_angles[k], widths[k]), true);
    if (!closed) around.points.insert(around.points.end(), fold.points.begin(), fold.points.end() - 1);
    if (closed) loops.push_back(fold.points.empty() ? Curve{{}, true} : std::move(fold));
  }
  if (!closed) loops.push_back(std::move(around));
  return loops;
}

/// A drawing and its fold samples.
struct FoldDrawing {
  Template fruit;
  std::vector<double> widths;
  std::vector<FoldSamples> samples;
  HalfTurn half_turn;

  explicit FoldDrawing(const Template& drawn)
      : fruit(drawn),
        widths(fold_widths(std::get<FoldSymmetry>(drawn.symmetry))),
        samples(fold_samples(drawn)),
        half_turn(drawn, samples) {}
};

/// Draws that repeat the drawn folds in turn, for what does not vary.
std::vector<FoldDraw> as_drawn(std::vector<FoldDraw> draws) {
  for (FoldDraw& draw : draws) draw.rung = FoldDraw::drawn_rung;
  return draws;
}

struct FoldCandidate {
  Template fruit;
  std::vector<std::vector<PolarCurve>> folds;  ///< for each of FoldDrawing::samples, in the pie-shaped space
};

/// [sample of FoldDrawing::samples][fold]: true if the fold has it.
using Bearing = std::vector<std::vector<bool>>;

/// The bearing of the drawn folds, repeated in turn.
Bearing drawn_bearing(const FoldDrawing& drawing, const std::vector<FoldDraw>& draws) {
  Bearing bearing;
  for (const FoldSamples& samples : drawing.samples) {
    const std::vector<bool> present = presence(samples);
    std::vector<bool>& folds = bearing.emplace_back();
    for (const FoldDraw& draw : draws) folds.push_back(present[draw.source]);
  }
  return bearing;
}

/// The bearing of a variant: random where the template says that not all folds have a surface.
Bearing varied_bearing(const FoldDrawing& drawing, const std::vector<FoldDraw>& draws, VariantKey key, double amount) {
  Bearing bearing = drawn_bearing(drawing, draws);
  for (std::size_t s = 0; s < bearing.size(); ++s) {
    const std::size_t surface = drawing.samples[s].surface;
    if (!drawing.samples[s].closed) continue;
    bearing[s] = varied_presence(drawing.fruit, static_cast<int>(surface), bearing[s], key, amount);
  }
  return bearing;
}

FoldCandidate candidate(const FoldDrawing& drawing, const std::vector<FoldDraw>& draws, const Bearing& bearing) {
  FoldCandidate result{drawing.fruit, {}};
  const double first = std::get<FoldSymmetry>(drawing.fruit.symmetry).fold_angles.front();
  const std::vector<double> widths = blended_widths(drawing.widths, draws);
  for (std::size_t s = 0; s < drawing.samples.size(); ++s) {
    const bool varies = drawing.fruit.surfaces[drawing.samples[s].surface].varies;
    result.folds.push_back(blended_folds(drawing.samples[s], varies ? draws : as_drawn(draws), bearing[s]));
  }

  // Meshes cannot be turned with the folds.
  const bool turns = drawing.fruit.meshes.empty();
  const double turn = turns ? drawing.half_turn(symmetry_of(first, widths), result.folds) : 0;
  const FoldSymmetry symmetry = symmetry_of(first + turn, widths);
  for (std::size_t s = 0; s < drawing.samples.size(); ++s) {
    SurfaceSketch& surface = result.fruit.surfaces[drawing.samples[s].surface];
    surface.reference = reference_radii(surface);
    std::vector<Curve> loops = loops_of(result.folds[s], symmetry, widths, drawing.samples[s].closed);
    if (drawing.samples[s].closed) {
      surface.horizontal = std::move(loops);
    } else {
      surface.horizontal[drawing.samples[s].loop] = std::move(loops.front());
    }
  }
  result.fruit.symmetry = symmetry;
  return result;
}

/// The fold in which an azimuth lies.
std::size_t fold_at(const FoldSymmetry& symmetry, double azimuth) {
  const double from = symmetry.fold_angles.front();
  azimuth -= 2 * pi * std::floor((azimuth - from) / (2 * pi));
  const auto next = std::upper_bound(symmetry.fold_angles.begin() + 1, symmetry.fold_angles.end(), azimuth);
  return static_cast<std::size_t>(next - symmetry.fold_angles.begin()) - 1;
}

/// What a variant's folds must satisfy.
struct Requirements {
  FoldRoom room;
  SweptCheck swept;
  std::vector<FoldForm> forms;  ///< for each of FoldDrawing::samples

  Requirements(const FoldDrawing& drawing, SweptCheck check) : room(drawing.fruit), swept(std::move(check)) {
    for (const FoldSamples& samples : drawing.samples) forms.emplace_back(samples);
  }

  /// Checks curves first; surfaces, which take longer, only if all curves are sound.
  std::vector<bool> are_met(const FoldCandidate& candidate) const {
    std::vector<bool> sound = room.is_sound(candidate.fruit);
    for (std::size_t s = 0; s < forms.size(); ++s) {
      for (std::size_t k = 0; k < sound.size(); ++k) sound[k] = sound[k] && forms[s].is_kept(candidate.folds[s][k]);
    }
    if (!all_of(sound)) return sound;
    for (const double azimuth : swept.new_crossings(candidate.fruit)) {
      sound[fold_at(std::get<FoldSymmetry>(candidate.fruit.symmetry), azimuth)] = false;
    }
    return sound;
  }

  static bool all_of(const std::vector<bool>& sound) {
    return std::find(sound.begin(), sound.end(), false) == sound.end();
  }
};

/// Moves every unsound fold one step nearer to the drawing, or, if it cannot move further, its neighbours. False if
/// nothing can move.
bool step_down(std::vector<FoldDraw>& draws, const std::vector<bool>& sound) {
  const std::size_t n = draws.size();
  std::vector<bool> steps(n, false);
  for (std::size_t k = 0; k < n; ++k) {
    if (sound[k]) continue;
    if (draws[k].rung < FoldDraw::drawn_rung) {
      steps[k] = true;
    } else {
      steps[(k + 1) % n] = steps[(k + n - 1) % n] = true;
    }
  }
  bool moved = false;
  for (std::size_t k = 0; k < n; ++k) {
    if (!steps[k] || draws[k].rung == FoldDraw::drawn_rung) continue;
    ++draws[k].rung;
    moved = true;
  }
  return moved;
}

}  // namespace

struct FoldVariation::Prepared {
  FoldDrawing drawing;
  Requirements requirements;

  Prepared(const Template& fruit, SweptCheck swept) : drawing(fruit), requirements(drawing, std::move(swept)) {}
};

FoldVariation::FoldVariation(const Template& fruit, SweptCheck swept)
    : prepared_(std::make_shared<Prepared>(fruit, std::move(swept))) {}

FoldVariant FoldVariation::draw(VariantKey key, double amount, int folds, bool drawn_counts) const {
  // Draw once, then only step towards the drawing, so that the loop ends.
  const auto& [drawing, requirements] = *prepared_;
  std::vector<FoldDraw> draws = drawn_folds(drawing.widths.size(), key, amount, folds);
  const Bearing bearing = drawn_counts ? drawn_bearing(drawing, draws) : varied_bearing(drawing, draws, key, amount);
  FoldCandidate result = candidate(drawing, draws, bearing);
  std::vector<bool> sound = requirements.are_met(result);
  while (!Requirements::all_of(sound) && step_down(draws, sound)) {
    result = candidate(drawing, draws, bearing);
    sound = requirements.are_met(result);
  }

  FoldVariant variant{std::move(result.fruit), {}};
  for (std::size_t k = 0; k < draws.size(); ++k) variant.folds.push_back({draws[k].rung, sound[k]});
  return variant;
}

Template repeat_folds(const Template& fruit, int folds) {
  if (folds == fold_count(fruit)) return fruit;
  const FoldDrawing drawing(fruit);
  const std::vector<FoldDraw> draws = as_drawn(drawn_folds(drawing.widths.size(), {}, 0, folds));
  return candidate(drawing, draws, drawn_bearing(drawing, draws)).fruit;
}

}  // namespace pomona
