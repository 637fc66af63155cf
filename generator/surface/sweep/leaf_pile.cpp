// A pile of leaves: heights over a disc about the pole, each leaf on the envelope of those before it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/clipped_normal.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/sheet_shells.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

// The ground is a disc whose middle is the pole and whose edge, at 1, is where leaves leave the axis.
constexpr int cells = 193;            // of the ground to either side
constexpr double ground_span = 1.12;  // half the width of the ground's grid
constexpr int smoothing = 2;          // radius of the envelope's boxes, cells
constexpr int fewest = 8;             // vertices along an edge: leaves of longer facets find no room in each other
constexpr int table_steps = 400;      // of ramps and curves
constexpr double table_end = 2;       // the last place of a ramp

double cell_place(int i) { return ground_span * (2.0 * i / (cells - 1) - 1); }

/// A ramp at even places, quick to look up.
class RampTable {
 public:
  explicit RampTable(const Ramp<double>& ramp) {
    for (int i = 0; i <= table_steps; ++i) value_.push_back(ramp(table_end * i / table_steps));
  }
  double operator()(double place) const {
    const double at = std::clamp(place / table_end, 0.0, 1.0) * table_steps;
    const auto i = static_cast<std::size_t>(std::min(std::floor(at), table_steps - 1.0));
    return value_[i] + (at - static_cast<double>(i)) * (value_[i + 1] - value_[i]);
  }

 private:
  std::vector<double> value_;
};

/// Heights over the ground.
class Ground {
 public:
  explicit Ground(double height = 0) : height_(static_cast<std::size_t>(cells) * cells, height) {}
  double& at(int i, int j) { return height_[static_cast<std::size_t>(i * cells + j)]; }
  double at(int i, int j) const { return height_[static_cast<std::size_t>(i * cells + j)]; }

  double operator()(const glm::dvec2& p) const {
    const double x = std::clamp((p.x + ground_span) / (2 * ground_span), 0.0, 1.0) * (cells - 1);
    const double y = std::clamp((p.y + ground_span) / (2 * ground_span), 0.0, 1.0) * (cells - 1);
    const int i = std::min(static_cast<int>(x), cells - 2), j = std::min(static_cast<int>(y), cells - 2);
    const double a = x - i, b = y - j;
    return (1 - a) * ((1 - b) * at(i, j) + b * at(i, j + 1)) + a * ((1 - b) * at(i + 1, j) + b * at(i + 1, j + 1));
  }

  /// Of the square of 2 r + 1 cells about each: the largest, or the mean.
  Ground largest(int r) const {
    return boxed(
        r, [](double sum, double one) { return std::max(sum, one); }, 1);
  }
  Ground mean(int r) const {
    return boxed(
        r, [](double sum, double one) { return sum + one; }, 2 * r + 1);
  }

  /// Smooth, and nowhere lower than within `reach` cells: the mean of a square's largest is no less than its middle.
  Ground envelope(int reach) const {
    return largest(smoothing + reach).mean(smoothing).largest(smoothing).mean(smoothing);
  }

 private:
  /// Row by row, so that neighbours are joined at once; each cell joins its square in the order of the cells.
  template <typename Join>
  Ground boxed(int r, const Join& join, double divisor) const {
    constexpr auto row = static_cast<std::size_t>(cells);
    const auto near = [](int i) { return static_cast<std::size_t>(std::clamp(i, 0, cells - 1)); };
    Ground across, result;
    std::vector<double> padded(row + 2 * static_cast<std::size_t>(r));
    for (int i = 0; i < cells; ++i) {
      for (int j = -r; j < cells + r; ++j) padded[static_cast<std::size_t>(j + r)] = height_[near(i) * row + near(j)];
      double* const sum = &across.height_[near(i) * row];
      std::copy_n(padded.begin(), row, sum);
      for (int k = 1; k <= 2 * r; ++k) {
        const double* const one = &padded[static_cast<std::size_t>(k)];
        for (std::size_t j = 0; j < row; ++j) sum[j] = join(sum[j], one[j]);
      }
      for (std::size_t j = 0; j < row; ++j) sum[j] /= divisor;
    }
    for (int i = 0; i < cells; ++i) {
      double* const sum = &result.height_[near(i) * row];
      std::copy_n(&across.height_[near(i - r) * row], row, sum);
      for (int k = i - r + 1; k <= i + r; ++k) {
        const double* const one = &across.height_[near(k) * row];
        for (std::size_t j = 0; j < row; ++j) sum[j] = join(sum[j], one[j]);
      }
      for (std::size_t j = 0; j < row; ++j) sum[j] /= divisor;
    }
    return result;
  }

  std::vector<double> height_;
};

/// Nested curves: height 0 is the inner one, 1 the outer one.
class Foliation {
 public:
  explicit Foliation(const SheetSketch& sketch)
      : inner_(resampled(sketch.inner, table_steps + 1).points),
        outer_(resampled(sketch.outer, table_steps + 1).points) {}

  glm::dvec3 at(double height, const glm::dvec2& ground) const {
    const double distance = glm::length(ground);
    const glm::dvec2 towards = distance > 1e-12 ? ground / distance : glm::dvec2(1, 0);
    const glm::dvec2 low = on(inner_, 1 - distance), high = on(outer_, 1 - distance), p = low + height * (high - low);
    const double radius = std::max(p.x, 1e-6);
    return {radius * towards.x, p.y, -radius * towards.y};
  }

  /// How far a chord of this length, a share of the curves, leaves the more bent of the two there, metres.
  double sag(double place, double chord) const {
    double most = 0;
    for (const std::vector<glm::dvec2>* curve : {&inner_, &outer_}) {
      const glm::dvec2 middle = 0.5 * (over(*curve, place - chord / 2) + over(*curve, place + chord / 2));
      most = std::max(most, glm::distance(middle, over(*curve, place)));
    }
    return most;
  }

  /// The radius of the outer curve, metres.
  double radius(double place) const { return std::fabs(over(outer_, place).x); }

  /// Metres from height 0 to height 1.
  double depth(const glm::dvec2& ground) const {
    const double place = 1 - glm::length(ground);
    return std::max(1e-6, glm::distance(on(outer_, place), on(inner_, place)));
  }

 private:
  /// Before its start a curve goes on straight: the corners of a broad base lie a little beyond the disc.
  static glm::dvec2 on(const std::vector<glm::dvec2>& curve, double place) {
    const double at = std::min(place, 1.0) * table_steps;
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(at), 0.0, table_steps - 1.0));
    return curve[i] + (at - static_cast<double>(i)) * (curve[i + 1] - curve[i]);
  }

  /// Beyond its end a curve goes down the other side.
  static glm::dvec2 over(const std::vector<glm::dvec2>& curve, double place) {
    if (place <= 1) return on(curve, place);
    const glm::dvec2 p = on(curve, 2 - place);
    return {-p.x, p.y};
  }

  std::vector<glm::dvec2> inner_, outer_;
};

/// What is drawn by lot for one leaf.
struct LeafChance {
  double age = 0;
  glm::dvec2 turn{1, 0};   ///< cosine and sine of its azimuth
  double tip = 1;          ///< the place where it ends
  double end = table_end;  ///< the place beyond which no point of it lies
  double width = 1;        ///< factor of the outline
  double phase = 0;        ///< of its waves
  double skew = 0;         ///< of its tip
};

LeafChance leaf_chance(const SheetSketch& sketch, const RandomStream& random, int k) {
  const auto n = static_cast<std::uint64_t>(k);
  const auto normal = [&](std::uint64_t draw) { return clipped_normal(random, 4 * n + draw); };
  LeafChance leaf;
  if (sketch.kind == SheetSketch::Kind::rosette) leaf.end = rosette_end;
  leaf.age = age_of(sketch, k);
  const double azimuth = sketch.divergence * k + sketch.turn_jitter * normal(0);
  leaf.turn = {reproducible::cos(azimuth), reproducible::sin(azimuth)};
  leaf.tip = sketch.reach(leaf.age) * (1 + sketch.reach_jitter * normal(1));
  leaf.width = 1 + sketch.outline_jitter * normal(2);
  leaf.skew = 0.05 * normal(3);
  leaf.phase = 2 * pi * random.uniform(n);
  return leaf;
}

/// One leaf after another, from the youngest.
class LeafPile {
 public:
  LeafPile(const SheetSketch& sketch, const SweepOptions& options)
      : sketch_(sketch),
        foliation_(sketch),
        outline_(sketch.outline),
        thickness_(sketch.thickness),
        rib_(sketch.rib.height),
        around_(refined(sketch.around, options.detail, fewest)),
        along_(refined(sketch.along, options.detail, fewest)) {
    double wide = 0, far = 0;
    for (const auto& stop : sketch.outline.stops) wide = std::max(wide, stop.value);
    for (const auto& stop : sketch.reach.stops) far = std::max(far, stop.value);
    const double edge = std::max(2 * wide / (around_ - 1), far / (along_ - 1));
    sag_ = sag_of(wide, far);
    facet_ = std::min(8, static_cast<int>(std::ceil(0.5 * edge * (cells - 1) / (2 * ground_span))));
    const RandomStream random(options.key, "sheet/" + sketch.name);
    for (int k = 0; k < sketch.count; ++k) leaves_.push_back(leaf_chance(sketch, random, k));
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) depth_.at(i, j) = foliation_.depth({cell_place(i), cell_place(j)});
  }

  /// Heights of a leaf's two faces at its vertices.
  struct Faces {
    std::vector<glm::dvec2> ground;
    std::vector<double> lower, upper;
  };

  /// A pile, with this gap between its leaves, metres.
  /// \param divisor what heights are divided by afterwards, about: gaps are so much higher before
  /// \param take called with each leaf and what it lies on
  template <typename Take>
  Ground piled(double gap, const Ground& divisor, const Take& take) const {
    Ground top;
    for (const LeafChance& leaf : leaves_) {
      const Ground floor = top.envelope(facet_);
      take(leaf, floor);
      cover(leaf, floor, gap, divisor, top);
    }
    return top;
  }

  /// How high it is with gaps of this size, and a divisor of 1.
  Ground height(double gap) const {
    return piled(gap, Ground(1), [](const LeafChance&, const Ground&) {});
  }

  struct Leaves {
    std::vector<Faces> faces;
    Ground top;
  };
  Leaves leaves(double gap, const Ground& divisor) const {
    Leaves all;
    all.top = piled(gap, divisor, [&](const LeafChance& leaf, const Ground& floor) {
      all.faces.push_back(faces_of(leaf, floor, gap, divisor));
    });
    return all;
  }

  SweptGrid shell(const Faces& faces, const Ground& divisor, int leaf) const {
    std::vector<glm::dvec3> lower, upper;
    for (std::size_t v = 0; v < faces.ground.size(); ++v) {
      const glm::dvec2& ground = faces.ground[v];
      const double by = divisor(ground);
      lower.push_back(foliation_.at(faces.lower[v] / by, ground));
      upper.push_back(foliation_.at(faces.upper[v] / by, ground));
    }
    return sheet_shell(lower, upper, around_, along_, age_of(sketch_, leaf));
  }

 private:
  /// By the place: how far flat facets may leave the curved leaf, metres. Gaps are so much wider.
  std::vector<double> sag_of(double wide, double far) const {
    std::vector<double> sag;
    for (int i = 0; i <= table_steps; ++i) {
      const double place = table_end * i / table_steps;
      const double across = 2 * std::min(wide, outline_(place)) / (around_ - 1);
      const double ground = std::max(0.3, std::fabs(1 - place)), aside = across / ground;
      const double rib = across / sketch_.rib.width;
      sag.push_back(foliation_.sag(place, far / (along_ - 1)) + aside * aside * foliation_.radius(place) / 8 +
                    rib_(place) * rib * rib / 4);
    }
    return sag;
  }
  double gap_at(double gap, double y) const {
    const double at = std::clamp(y / table_end, 0.0, 1.0) * table_steps;
    return gap + sag_[static_cast<std::size_t>(at)];
  }

  /// Half the width of a leaf there. Its rows lie straight across its middle, so that nothing folds, and end within the
  /// disc.
  double half_width(const LeafChance& leaf, double y) const {
    const double x = 1 - y;
    return std::min(leaf.width * outline_(y), 0.97 * std::sqrt(std::max(0.0, 1.04 - x * x)));
  }

  /// Places along at the tip, across: round.
  static double tip_at(const LeafChance& leaf, double across) {
    const double side = std::fabs(across);
    return std::min(leaf.end, leaf.tip * (1 - 0.16 * side * side * std::sqrt(side)) + leaf.skew * across);
  }

  /// How far a leaf stands off from what it lies on, and how thick it is, metres.
  double lift(const LeafChance& leaf, double across, double y) const {
    const double side = std::fabs(across), margin = side * side * side * std::clamp(3 * y, 0.0, 1.0);
    const double wave =
        sketch_.ruffle.waves * 2 * pi * y + leaf.phase + (across < 0 ? -2 : 2);  // both margins wave by themselves
    const double tip = std::clamp((y / leaf.tip - 0.6) / 0.4, 0.0, 1.0), age = leaf.age * leaf.age;
    const double ruffle =
        sketch_.ruffle.height > 0 ? sketch_.ruffle.height * margin * (0.5 + 0.5 * reproducible::sin(wave)) : 0;
    return ruffle + sketch_.stand_off * age * age * tip * tip;
  }
  double thick(const LeafChance& leaf, double across, double y) const {
    const double edge =
        std::clamp((1 - std::fabs(across)) / 0.1, 0.2, 1.0) * std::clamp((1 - y / leaf.tip) / 0.06, 0.3, 1.0);
    const double rib = rib_(y), aside = across * leaf.width * outline_(y) / sketch_.rib.width;
    return sketch_.by_age(leaf.age) * (thickness_(y) * edge + (rib > 0 ? rib * reproducible::exp(-aside * aside) : 0));
  }

  Faces faces_of(const LeafChance& leaf, const Ground& floor, double gap, const Ground& divisor) const {
    Faces faces;
    for (int j = 0; j < along_; ++j) {
      for (int i = 0; i < around_; ++i) {
        const double across = 2.0 * i / (around_ - 1) - 1, y = tip_at(leaf, across) * j / (along_ - 1);
        const glm::dvec2 at{1 - y, across * half_width(leaf, y)};
        const glm::dvec2 ground{at.x * leaf.turn.x - at.y * leaf.turn.y, at.x * leaf.turn.y + at.y * leaf.turn.x};
        const double depth = foliation_.depth(ground);
        const double low =
            floor(ground) + (gap_at(gap, y) * std::max(1.0, divisor(ground)) + lift(leaf, across, y)) / depth;
        faces.ground.push_back(ground);
        faces.lower.push_back(low);
        faces.upper.push_back(low + thick(leaf, across, y) / depth);
      }
    }
    return faces;
  }

  /// Raises what the leaf lies over, and a cell more to every side.
  void cover(const LeafChance& leaf, const Ground& floor, double gap, const Ground& divisor, Ground& top) const {
    constexpr double margin = 1.03;
    const double farthest = 1.015 * (std::max(leaf.tip, 0.0) + std::fabs(leaf.skew));  // no tip lies beyond it
    Ground raised;
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const glm::dvec2 ground{cell_place(i), cell_place(j)};
        const double x = ground.x * leaf.turn.x + ground.y * leaf.turn.y, y = 1 - x;
        if (y < -0.04 || y > farthest) continue;
        const double half = half_width(leaf, y);
        if (!(half > 0)) continue;
        const double wide = (ground.y * leaf.turn.x - ground.x * leaf.turn.y) / half;
        const double across = std::clamp(wide, -1.0, 1.0), tip = tip_at(leaf, across);
        if (std::fabs(wide) > margin || y > 1.015 * tip) continue;
        const double place = std::clamp(y, 0.0, tip);
        raised.at(i, j) = floor.at(i, j) + (gap_at(gap, place) * std::max(1.0, divisor.at(i, j)) +
                                            lift(leaf, across, place) + thick(leaf, across, place)) /
                                               depth_.at(i, j);
      }
    }
    raised = raised.largest(1);
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) top.at(i, j) = std::max(top.at(i, j), raised.at(i, j));
  }

  const SheetSketch& sketch_;
  Foliation foliation_;
  RampTable outline_, thickness_, rib_;
  int around_, along_;
  std::vector<double> sag_;
  int facet_ = 0;  ///< half an edge of the mesh, in cells: facets are flat where what they lie on bulges
  std::vector<LeafChance> leaves_;
  Ground depth_;
};

/// The median height half-way between base and pole.
double usual_height(const Ground& top) {
  std::vector<double> heights;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double distance = glm::length(glm::dvec2(cell_place(i), cell_place(j)));
      if (distance > 0.35 && distance < 0.6) heights.push_back(top.at(i, j));
    }
  }
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

/// What heights are divided by, so that the last leaf lies on the outer curve: the pile's own height, smoothed. At the
/// base it is at least 1: a low pile is not drawn out of what it grows from. No order changes.
Ground divisor_of(const Ground& top) {
  Ground divisor = top;
  for (int pass = 0; pass < 4; ++pass) divisor = divisor.mean(5);
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double distance = glm::length(glm::dvec2(cell_place(i), cell_place(j)));
      const double share = std::clamp((0.93 - distance) / 0.35, 0.0, 1.0), smooth = share * share * (3 - 2 * share);
      const double own = std::max(divisor.at(i, j), 0.5);
      divisor.at(i, j) = std::max(own, 1 + smooth * (own - 1));
    }
  }
  return divisor;
}

}  // namespace

namespace {

/// What room is left between the two curves, is shared by the gaps: the height of the pile is nearly linear in them.
double shared_gap(const Template& fruit, const SheetSketch& sketch, const LeafPile& pile, const Ground& least) {
  const Ground wider = pile.height(3 * sketch.gap);
  const double low = usual_height(least), slope = (usual_height(wider) - low) / (2 * sketch.gap);
  if (low > 4)
    refuse_entry(fruit, "sheets", sketch.name, "so many leaves have no room",
                 "make them fewer or thinner, or the outer curve wider");
  return slope > 0 ? sketch.gap + std::clamp((1 - low) / slope, 0.0, 0.01) : sketch.gap;
}

}  // namespace

SheetShell leaf_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options) {
  const LeafPile pile(sketch, options);
  Ground divisor(1);
  double gap = sketch.gap;
  if (sketch.kind == SheetSketch::Kind::head) {
    const Ground least = pile.height(sketch.gap);
    gap = shared_gap(fruit, sketch, pile, least);
    divisor = divisor_of(least);
  }
  const LeafPile::Leaves leaves = pile.leaves(gap, divisor);
  if (sketch.kind == SheetSketch::Kind::head) divisor = divisor_of(leaves.top);
  return [pile, faces = leaves.faces, divisor](int leaf) {
    return pile.shell(faces[static_cast<std::size_t>(leaf)], divisor, leaf);
  };
}

}  // namespace pomona
