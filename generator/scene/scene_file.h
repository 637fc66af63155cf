// The description of a scene in a scene file: dishes, and pieces of fruit (docs/reference/formats.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/error.h"
#include "generator/knife/knife.h"
#include "generator/scene/dish_description.h"
#include "generator/scene/scene.h"
#include "generator/scene/settle/piece_arrangement.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

inline constexpr std::size_t max_scene_pieces = 100'000;

/// Some variants of one template, all cut the same way.
struct PiecesDescription {
  std::string name;           ///< unique in the scene; it selects the variants' random numbers
  SourcePlace place;          ///< place of the name
  std::string template_name;  ///< as on the command line; a path is relative to the scene's folder
  SourcePlace template_place;
  int count = 1;  ///< number of variants
  bool as_drawn = false;
  std::optional<int> folds;
  double variation = 1;
  double detail = 1;               ///< factor of the tessellation's detail, besides that of the command
  std::optional<Within> size;      ///< factor of the size, uniformly random for each variant; else 1
  std::optional<Within> ripeness;  ///< 0..2, uniformly random for each variant; else as the template says
  std::optional<Within> browning;  ///< 0..1, uniformly random for each variant; else 0
  std::vector<Knife> knives;
  int take = 0;            ///< number of pieces of each variant that are used, the largest first; 0 = all
  int copies = 1;          ///< how often each piece is placed, if neither `total` nor `share` is given
  int total = 0;           ///< number of all placed pieces; each is placed equally often, up to one; 0 = not given
  double share = 0;        ///< share of the scene's total; 0 = not given
  double smallest = 0.01;  ///< pieces with a smaller share of the fruit's volume are not used
  double largest = 1;      ///< pieces with a larger share of the fruit's volume are not used
  int order = 0;           ///< pieces with a lower order fall first; a garnish comes last
  bool face_up = false;    ///< dropped with the largest cut face up
  bool upright = false;    ///< in the orientation in which it grew
  bool beside = false;     ///< around the bowl instead of into it
  std::string dish;        ///< name of a dish of the scene; empty = the bowl, or the ground if there is no bowl
  bool on_top = false;     ///< on that dish, not in it
  std::optional<PieceArrangement> where{};  ///< nothing = dropped anywhere in the dish
};

struct SceneDescription {
  std::string file;  ///< for messages
  std::string name, title;
  std::uint64_t seed = 0;
  std::optional<Color> paper;  ///< nothing = the paper of the style
  std::string style;           ///< name or path (.toml), relative to the scene's folder; empty = the default
  std::optional<View> view;    ///< given by eye and target
  glm::dvec3 view_direction{0, 0.75, 1.0};  ///< without `view`: from the target to the eye; the distance is fitted
  double vertical_field = 0.5;              ///< field of view, radians
  int width = 1200, height = 900;           ///< default size of a picture, pixels
  bool ground = true;
  std::optional<BowlDescription> bowl;
  SourcePlace bowl_place;
  std::vector<DishDescription> dishes;
  int total = 0;  ///< number of pieces of all entries with a share
  std::vector<PiecesDescription> pieces;
  std::string layout;  ///< poses from this file instead of physics; relative to the scene's folder
  SourcePlace layout_place;
  double friction = 0.6;
  double fill = 0.92;   ///< see SettleOptions
  double spread = 0;    ///< see SettleOptions
  double around = 1.8;  ///< see SettleOptions
  int attempts = 5;
};

/// \throws Error (bad_data) with all errors, also unknown keys, ordered by position.
SceneDescription parse_scene(std::string_view toml, const std::string& file);

/// The same from disk.
/// \throws Error (input_missing) if it cannot be read.
SceneDescription read_scene(const std::filesystem::path& file);

/// True for a .toml file that has pieces or a bowl: it is a scene, not a template.
bool is_scene_file(const std::filesystem::path& file);

}  // namespace pomona
