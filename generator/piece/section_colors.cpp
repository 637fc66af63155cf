#include "generator/piece/section_colors.h"

#include <utility>

#include "generator/piece/brown.h"

namespace pomona {

namespace {

/// A diffuser's field, with the section's browning.
class BrownedField final : public ColorField {
 public:
  BrownedField(std::unique_ptr<ColorField> diffused, const DiffusionSurfaces& surfaces, const Template& fruit)
      : diffused_(std::move(diffused)), surfaces_(surfaces), fruit_(fruit) {}

  DiffusedColors at(std::span<const glm::vec3> points) const override {
    return browned(diffused_->at(points), points, surfaces_, fruit_);
  }

 private:
  std::unique_ptr<ColorField> diffused_;
  const DiffusionSurfaces& surfaces_;
  const Template& fruit_;
};

}  // namespace

SectionColors::SectionColors(DiffusionSurfaces surfaces, Template fruit, const Diffuser& diffuser)
    : surfaces_(std::move(surfaces)), fruit_(std::move(fruit)), diffuser_(diffuser) {}

std::unique_ptr<ColorField> SectionColors::field() const {
  return std::make_unique<BrownedField>(diffuser_.field(surfaces_), surfaces_, fruit_);
}

std::vector<Solid> with_section_colors(std::vector<Solid> solids, std::shared_ptr<const SectionColors> colors) {
  for (Solid& solid : solids) solid.section_colors = colors;
  return solids;
}

}  // namespace pomona
