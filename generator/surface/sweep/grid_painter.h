// From grids to painted diffusion surfaces.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/swept_grid.h"
#include "generator/template/side.h"

namespace pomona {

/// A vertex, with the attributes that paint needs. Where a position is not defined, as around at a pole, ramps give
/// their mean.
struct PaintPlace {
  double along = 0;
  std::optional<double> around;
  std::optional<double> turn;
  std::optional<int> fold;  ///< and the one before it on a fold line, else the same again
  int fold_before = 0;
  std::optional<double> cell;  ///< place in a cell of the side that is painted
};

PaintPlace paint_place(const SweptGrid& grid, std::size_t vertex);

/// A ramp that knows its mean.
template <typename Value>
class MeanRamp {
 public:
  explicit MeanRamp(const Ramp<Value>& ramp) : ramp_(ramp) {
    constexpr int samples = 64;
    Value sum{0};
    for (int i = 0; i < samples; ++i) sum += ramp((i + 0.5) / samples);
    mean_ = sum / static_cast<float>(samples);
  }
  Value operator()(const std::optional<double>& place) const { return place ? ramp_(*place) : mean_; }

 private:
  Ramp<Value> ramp_;
  Value mean_;
};

/// Values that are assigned to the folds in turn.
template <typename Value>
class FoldValues {
 public:
  FoldValues(std::vector<Value> values, const Value& where_none) : values_(std::move(values)) {
    if (values_.empty()) values_.push_back(where_none);
    Value sum{0};
    for (const Value& value : values_) sum += value;
    mean_ = sum / static_cast<float>(values_.size());
  }
  Value operator()(const PaintPlace& place) const {
    if (!place.fold) return mean_;
    const Value &here = of(*place.fold), &before = of(place.fold_before);
    return *place.fold == place.fold_before ? here : (here + before) * 0.5f;
  }

 private:
  const Value& of(int fold) const { return values_[static_cast<std::size_t>(fold) % values_.size()]; }
  std::vector<Value> values_;
  Value mean_;
};

/// Ground, coats and cells of one side.
class SidePaint {
 public:
  explicit SidePaint(const Side& side);
  Color operator()(const PaintPlace& place) const;

 private:
  struct CoatPaint {
    explicit CoatPaint(const Coat& coat);
    Ramp<Color> color;
    Ramp<double> along;
    MeanRamp<double> around, turn;
    FoldValues<double> folds;
  };
  Ramp<Color> along_;
  MeanRamp<Color> around_, turn_;
  FoldValues<Color> folds_;
  std::vector<CoatPaint> coats_;
  std::optional<CellSketch> cells_;
};

/// The blur of a surface, metres.
class BlurPaint {
 public:
  explicit BlurPaint(const PaintedBlur& blur) : along_(blur.along), around_(blur.around), turn_(blur.turn) {}
  double operator()(const PaintPlace& place) const {
    return along_(place.along) * around_(place.around) * turn_(place.turn);
  }

 private:
  Ramp<double> along_;
  MeanRamp<double> around_, turn_;
};

/// Collects grids as one named surface with the colours, parts and blur of a sketch.
class GridPainter {
 public:
  /// Adds a surface of this name to `surfaces`, which must outlive the painter.
  GridPainter(DiffusionSurfaces& surfaces, const std::string& name, const Side& front, const Side& back,
              const PaintedBlur& blur);

  void append(const SweptGrid& grid);

  /// Paints spots over one side of the grids, which must be all that have been appended, in the same order.
  void dab(SideOf side, std::span<const Spot> spots, std::span<const SweptGrid> grids);

 private:
  void append_vertex(const SweptGrid& grid, std::size_t vertex);

  DiffusionSurfaces& surfaces_;
  std::int32_t index_;
  std::size_t first_vertex_;
  const Side& front_;
  const Side& back_;
  SidePaint front_paint_, back_paint_;
  BlurPaint blur_;
};

}  // namespace pomona
