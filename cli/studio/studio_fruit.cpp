#include "cli/studio/studio_fruit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/base/error.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"

namespace pomona {

namespace {

constexpr std::size_t max_kept = 3;  // the fruit that is dragged, the fruit as drawn, and the shown variant

std::shared_ptr<const StudioFruit> grow_anew(const WantedFruit& wanted, const std::filesystem::path& file) {
  auto fruit = std::make_shared<StudioFruit>();
  fruit->wanted = wanted;
  GrowOptions& growing = fruit->order.fruit.growing;
  fruit->order.fruit.seed = wanted.seed;
  growing.folds = wanted.folds;
  growing.ripeness = wanted.ripeness;
  growing.browning = wanted.browning;
  growing.detail = wanted.detail;
  fruit->order.color.quality = wanted.draft ? Quality::draft : Quality::final;
  const FruitTexts& texts = wanted.texts;
  fruit->drawn = parse_drawn_template(texts.toml, file.string(),
                                      texts.svg.empty() ? std::nullopt : std::optional<std::string_view>(texts.svg));
  fruit->source = ordered_fruit(fruit->drawn.fruit, file.stem().string(), file.string(), fruit->order);
  return fruit;
}

/// Adds a margin of a hundredth, so that edges are not cut off.
PictureFrame framed(const glm::dvec3& corner, const glm::dvec3& right, const glm::dvec3& down, int size) {
  const glm::dvec3 margin = 0.01 * (right + down);
  const double width = 1.02 * glm::length(right), height = 1.02 * glm::length(down);
  const double pixels = size / std::max(width, height);
  return {corner - margin, 1.02 * right, 1.02 * down, std::max(1, static_cast<int>(std::lround(width * pixels))),
          std::max(1, static_cast<int>(std::lround(height * pixels)))};
}

}  // namespace

const ColorField& StudioFruit::field() const {
  std::call_once(solved_, [this] {
    // Finer patches around seeds take as long as all the rest, so dragging goes without them.
    const HarmonicOptions quick{.quality = Quality::draft, .finer = 0};
    field_ = make_harmonic_diffuser(wanted.draft ? quick : HarmonicOptions{})->field(source.grown.sheets);
  });
  return *field_;
}

std::shared_ptr<const StudioFruit> StudioFruits::grown(const WantedFruit& wanted) {
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const auto& kept) { return kept->wanted == wanted; });
  if (known != kept_.end()) {
    std::rotate(known, known + 1, kept_.end());
    return kept_.back();
  }
  std::shared_ptr<const StudioFruit> fruit = grow_anew(wanted, file_);
  kept_.push_back(fruit);
  if (kept_.size() > max_kept) kept_.erase(kept_.begin());
  return fruit;
}

std::vector<SectionPicture> section_pictures(const StudioFruit& fruit, int size, double height) {
  const DiffusionSurfaces& surfaces = fruit.source.grown.sheets;
  const Box<double> box = bounds_of(surfaces);
  const glm::dvec3 low = box.low, high = box.high, whole = box.size();
  const double level = low.y + height * whole.y;
  std::vector<SectionPicture> pictures;
  pictures.push_back(
      {"side", framed({low.x, high.y, 0}, {whole.x, 0, 0}, {0, -whole.y, 0}, size), std::vector<std::uint8_t>()});
  pictures.push_back(
      {"top", framed({low.x, level, low.z}, {whole.x, 0, 0}, {0, 0, whole.z}, size), std::vector<std::uint8_t>()});
  for (SectionPicture& picture : pictures) picture.pixels = plane_picture(surfaces, fruit.field(), picture.frame);
  return pictures;
}

}  // namespace pomona
