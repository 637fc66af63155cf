#include "generator/data/drawn_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"

namespace pomona {

namespace {

/// LawDraws one after another from a stream of their own, so that no group of laws depends on another.
class LawDraws {
 public:
  LawDraws(const DataPlan& plan, std::int64_t number, const char* purpose)
      : stream_({plan.data.seed, static_cast<std::uint64_t>(number)}, purpose) {}

  double uniform() { return stream_.uniform(next_++); }
  double in(const Within& range) { return range.low + (range.high - range.low) * uniform(); }
  std::optional<double> in(const std::optional<Within>& range) {
    const double at = uniform();
    if (!range) return {};
    return range->low + (range->high - range->low) * at;
  }
  int in(const WholeLaw& law) {
    return law.low + static_cast<int>(among(static_cast<std::size_t>(law.high - law.low) + 1));
  }
  std::size_t among(std::size_t count) { return static_cast<std::size_t>(stream_.below(next_++, count)); }
  bool happens(double chance) { return uniform() < chance; }

 private:
  RandomStream stream_;
  std::uint64_t next_ = 0;
};

/// A plane with any normal, through a place within the middle of the fruit.
Knife random_plane(const Box<double>& extent, double scale, LawDraws& draws) {
  constexpr double inner = 0.35;  // of the half extents
  const double up = draws.in(Within{-1, 1}), around = draws.in(Within{0, 2 * pi});
  const double level = std::sqrt(std::max(0.0, 1 - up * up));
  const glm::dvec3 normal(level * reproducible::cos(around), up, level * reproducible::sin(around));
  glm::dvec3 place = extent.center();
  for (int k = 0; k < 3; ++k) place[k] += inner * 0.5 * extent.size()[k] * draws.in(Within{-1, 1});
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "plane:%.9g,%.9g,%.9g,%.9g", normal.x, normal.y, normal.z,
                scale * glm::dot(normal, place));
  return parse_knife(text.data());
}

std::vector<Knife> drawn_knives(const std::vector<KnifeLaw>& cut, const Box<double>& extent, double scale,
                                LawDraws& draws) {
  std::vector<Knife> knives;
  for (const KnifeLaw& knife : cut) {
    if (knife.knife) knives.push_back(*knife.knife);
    for (int plane = 0; plane < knife.random_planes; ++plane) knives.push_back(random_plane(extent, scale, draws));
  }
  return knives;
}

/// One fruit of the picture, with its pieces.
PiecesDescription drawn_fruit(const DataPlan& plan, int index, LawDraws& draws) {
  // Which kind, and which fruit of it.
  double at = draws.uniform();
  std::size_t k = 0;
  while (k + 1 < plan.kinds.size() && at >= plan.kinds[k].chance) at -= plan.kinds[k++].chance;
  const DataFruit& kind = plan.data.kinds[k];
  const std::size_t one = draws.among(plan.kinds[k].templates.size()), number = plan.kinds[k].templates[one];
  const Template& fruit = plan.templates[number].fruit;

  // How it grew, and what was done to it.
  PiecesDescription pieces;
  pieces.name = plan.templates[number].name + "-" + std::to_string(index + 1);
  pieces.place = kind.place;
  pieces.template_name = plan.kinds[k].words[one];
  pieces.template_place = kind.place;
  pieces.variation = kind.variation;
  const auto exactly = [](double value) { return Within{value, value}; };
  const double size = draws.in(kind.size);
  pieces.size = exactly(size);
  const std::optional<double> ripeness = draws.in(kind.ripeness), browning = draws.in(kind.browning);
  if (ripeness && fruit.ripeness.declared()) pieces.ripeness = exactly(*ripeness);
  if (browning && fruit.browning.declared()) pieces.browning = exactly(*browning);
  pieces.take = draws.in(kind.pieces);
  pieces.face_up = draws.happens(kind.face_up);
  pieces.knives = drawn_knives(kind.cuts[draws.among(kind.cuts.size())], plan.extents[number], size, draws);
  return pieces;
}

/// The dish that things lie in or on, if any.
void draw_dish(const DataDescription& data, SceneDescription& scene, LawDraws& draws) {
  std::vector<const DataDish*> dishes;
  for (const DataDish& dish : data.dishes)
    if (dish.use != DishUse::beside) dishes.push_back(&dish);
  const bool wanted = draws.happens(data.dish);
  if (!wanted || dishes.empty()) return;
  const DataDish& chosen = *dishes[draws.among(dishes.size())];
  scene.dishes.push_back(chosen.dish);
  for (PiecesDescription& pieces : scene.pieces) {
    pieces.dish = chosen.dish.name;
    pieces.on_top = chosen.use == DishUse::on;
  }
}

std::vector<DrawnDistractor> drawn_distractors(const DataDescription& data, LawDraws& draws) {
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < data.dishes.size(); ++i)
    if (data.dishes[i].use == DishUse::beside) beside.push_back(i);
  std::vector<DrawnDistractor> distractors;
  const int count = draws.in(data.distractors);
  for (int i = 0; i < count && !beside.empty(); ++i) {
    distractors.push_back({.dish = beside[draws.among(beside.size())],
                           .turn = draws.in(Within{0, 2 * pi}),
                           .direction = draws.in(Within{0, 2 * pi}),
                           .room = draws.in(Within{0, 0.05})});
  }
  return distractors;
}

void draw_view(const DataView& view, DrawnPicture& picture, LawDraws& draws) {
  picture.azimuth = draws.in(view.azimuth);
  picture.elevation = draws.in(view.elevation);
  picture.field = draws.in(view.field);
  picture.fit = draws.in(view.fit);
  picture.distance = draws.in(view.distance);
  picture.shift = {draws.in(view.shift), draws.in(view.shift)};
}

void draw_look(const DataDescription& data, DrawnPicture& picture, LawDraws& draws) {
  picture.style = data.styles[draws.among(data.styles.size())];
  picture.light_azimuth = draws.in(data.light.azimuth);
  picture.light_elevation = draws.in(data.light.elevation);
  picture.light_strength = draws.in(data.light.strength);
  picture.light_ambient = draws.in(data.light.ambient);
  picture.light_softness = draws.in(data.light.softness);
  picture.exposure = draws.in(data.camera.exposure);
  picture.blur = draws.in(data.camera.blur);
  picture.noise = draws.in(data.camera.noise);
}

void draw_ground(const DataGround& ground, DrawnPicture& picture, LawDraws& draws) {
  const std::size_t paper = draws.among(std::max<std::size_t>(1, ground.papers.size()));
  if (!ground.papers.empty()) picture.scene.paper = ground.papers[paper];
  const bool has_picture = draws.happens(ground.share) && !ground.pictures.empty();
  const std::size_t background = draws.among(std::max<std::size_t>(1, ground.pictures.size()));
  if (has_picture) picture.background = background;
  picture.crop = {draws.uniform(), draws.uniform()};
  picture.crop_size = draws.in(Within{0.5, 1});
}

}  // namespace

DrawnPicture drawn_picture(const DataPlan& plan, std::int64_t number, int attempt) {
  const DataDescription& data = plan.data;
  DrawnPicture picture;
  picture.split = split_of(data, number);

  // What is there. 53 bits of a seed, so that every reader of JSON has it exactly.
  SceneDescription& scene = picture.scene;
  const RandomStream seeds({data.seed, static_cast<std::uint64_t>(number)}, "data/seed");
  scene.file = data.file;
  scene.name = "picture";
  scene.seed = std::max<std::uint64_t>(1, seeds.bits(static_cast<std::uint64_t>(attempt)) >> 11);
  scene.width = data.width;
  scene.height = data.height;
  LawDraws content(plan, number, "data/content");
  const int fruits = content.in(data.fruits);
  for (int i = 0; i < fruits; ++i) scene.pieces.push_back(drawn_fruit(plan, i, content));
  LawDraws arrangement(plan, number, "data/arrangement");
  picture.arrangement = data.arrangements[arrangement.among(data.arrangements.size())];
  scene.spread = arrangement.in(data.spread);
  if (picture.arrangement == DataArrangement::heap) draw_dish(data, scene, arrangement);
  LawDraws distractors(plan, number, "data/distractors");
  picture.distractors = drawn_distractors(data, distractors);

  // How it is seen.
  LawDraws view(plan, number, "data/view"), look(plan, number, "data/look"), ground(plan, number, "data/ground");
  draw_view(data.view, picture, view);
  draw_look(data, picture, look);
  draw_ground(data.ground, picture, ground);
  return picture;
}

}  // namespace pomona
