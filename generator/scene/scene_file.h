// What a scene file says: dishes, and pieces of fruit to fill it with (docs/reference/formats.md).
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
#include "generator/template/read/toml_document.h"
#include "generator/template/template.h"

namespace pomona {

inline constexpr std::size_t most_scene_pieces = 100'000;

/// Some variants of one template, all cut the same way.
struct PiecesDescription {
  std::string name;           ///< unique in the scene; what the variants are drawn by
  SourcePlace place;          ///< of the name
  std::string template_name;  ///< as on the command line; a path is relative to the scene's folder
  SourcePlace template_place;
  int count = 1;  ///< variants
  bool as_drawn = false;
  std::optional<int> folds;
  double variation = 1;
  double detail = 1;               ///< of the tessellation, times that of the command
  std::optional<Within> size;      ///< times the variant's own, drawn evenly for each variant
  std::optional<Within> ripeness;  ///< 0..2, drawn evenly for each variant; else what the template draws
  std::optional<Within> browning;  ///< 0..1, likewise; else 0
  std::vector<Knife> knives;
  int take = 0;            ///< this many of each variant's pieces, the largest first; 0 = all
  int copies = 1;          ///< times that each piece is placed;
  int total = 0;           ///< else so many in all, each piece as often as the others, up to one; 0 = not said
  double share = 0;        ///< else of the scene's total; 0 = not said
  double smallest = 0.01;  ///< pieces below this share of the fruit's volume are left on the board,
  double largest = 1;      ///< and so are pieces above this one
  int order = 0;           ///< lower orders fall into the bowl first; a garnish comes last
  bool face_up = false;    ///< dropped with the largest cut face up
  bool upright = false;    ///< as it grew
  bool beside = false;     ///< around the bowl instead of into it
  std::string dish;        ///< one of the scene's; empty = the bowl, or the ground where there is none
  bool on_top = false;     ///< on that dish, not in it
  std::optional<PieceArrangement> where{};  ///< else dropped anywhere in the dish
};

struct SceneDescription {
  std::string file;  ///< for messages
  std::string name, title;
  std::uint64_t seed = 0;
  std::optional<Color> paper;               ///< else the style's
  std::string style;                        ///< name or path (.toml), relative to the scene's folder; else the default
  std::optional<View> view;                 ///< by eye and target
  glm::dvec3 view_direction{0, 0.75, 1.0};  ///< else from here, as near as shows all
  double vertical_field = 0.5;              ///< radians
  int width = 1200, height = 900;           ///< pixels of a picture unless asked otherwise
  bool ground = true;
  std::optional<BowlDescription> bowl;
  SourcePlace bowl_place;
  std::vector<DishDescription> dishes;
  int total = 0;  ///< pieces of the entries with a share, together
  std::vector<PiecesDescription> pieces;
  std::string layout;  ///< poses from this file instead of physics; relative to the scene's folder
  SourcePlace layout_place;
  double friction = 0.6;
  double fill = 0.92;   ///< see SettleOptions
  double spread = 0;    ///< see SettleOptions
  double around = 1.8;  ///< see SettleOptions
  int attempts = 5;
};

/// \throws Error (bad_data) with all that is wrong, unknown keys included, ordered by position.
SceneDescription parse_scene(std::string_view toml, const std::string& file);

/// The same from disk. \throws Error (input_missing) if it cannot be read.
SceneDescription read_scene(const std::filesystem::path& file);

/// True for a .toml file that speaks of pieces or of a bowl: a scene, not a template.
bool is_scene_file(const std::filesystem::path& file);

}  // namespace pomona
