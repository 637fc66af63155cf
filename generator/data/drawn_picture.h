// One picture of a data set as drawn at random: a pure function of the set's seed, its laws and the picture's number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/data/data_plan.h"
#include "generator/scene/scene_file.h"

namespace pomona {

/// Something that only stands about.
struct DrawnDistractor {
  std::size_t dish = 0;  ///< index into DataDescription::dishes
  double turn = 0;       ///< about the vertical, radians
  double direction = 0;  ///< from the middle, radians
  double room = 0;       ///< between it and what lies there, metres
};

/// Angles are radians.
struct DrawnPicture {
  std::string split;
  SceneDescription scene;  ///< what lies there, and where; not yet how it is seen
  DataArrangement arrangement = DataArrangement::heap;
  std::vector<DrawnDistractor> distractors;

  // The view.
  double azimuth = 0, elevation = 0, field = 0, fit = 1;
  std::optional<double> distance;
  glm::dvec2 shift{0};

  // The look.
  std::string style;
  std::optional<double> light_azimuth, light_elevation, light_strength, light_ambient, light_softness;
  std::optional<std::size_t> background;  ///< index into DataGround::pictures
  glm::dvec2 crop{0};                     ///< where in the background, 0..1 of the room that is left
  double crop_size = 1;                   ///< share of the largest part of the right shape
  double exposure = 0, blur = 0, noise = 0;
};

/// \param attempt from 0: where things cannot come to rest, another seed of the same scene may let them.
DrawnPicture drawn_picture(const DataPlan& plan, std::int64_t number, int attempt = 0);

}  // namespace pomona
