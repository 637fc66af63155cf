// Data set files: the laws by which pictures are drawn at random, each with its own content, view, light and look
// (docs/reference/formats.md, "Data set"). Read like batches, with the same kind of errors.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/color.h"
#include "generator/batch/batch_file.h"
#include "generator/diffusion/quality.h"
#include "generator/knife/knife.h"
#include "generator/order/export_choices.h"
#include "generator/scene/dish_description.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// A whole number, uniformly random from low to high.
struct WholeLaw {
  int low = 1, high = 1;
  double mean() const { return 0.5 * (low + high); }
};

/// A knife, or so many random planes through the fruit.
struct KnifeLaw {
  std::optional<Knife> knife;
  int random_planes = 0;
};

/// One kind of content. Each picture takes some, by their shares.
struct DataFruit {
  std::string name;
  SourcePlace place;
  bool all_templates = false;
  std::vector<TemplateWanted> templates;        ///< equally likely
  double share = 1;                             ///< of the pieces of the whole set
  std::vector<std::vector<KnifeLaw>> cuts{{}};  ///< equally likely ways to cut; knives of one cut one after another
  WholeLaw pieces;                              ///< of one fruit, the largest first
  std::optional<Within> ripeness, browning;     ///< where the template says how
  Within size{1, 1};                            ///< factor
  double variation = 1;
  double face_up = 0.5;  ///< how likely pieces fall with the largest cut face up
};

enum class DataArrangement : std::uint8_t { heap, rows };
enum class DataClasses : std::uint8_t { species, state, species_and_state };
enum class DataLayers : std::uint8_t { none, png, exr };
enum class DishUse : std::uint8_t { in, on, beside };

/// What things lie in or on, or that only stands about.
struct DataDish {
  DishDescription dish;
  DishUse use = DishUse::beside;
};

/// Angles are radians; a range is uniform.
struct DataView {
  Within azimuth{0, 6.283185307179586};  ///< from +Z towards +X
  Within elevation{0.35, 1.4};
  Within field{0.44, 0.7};
  Within fit{0.95, 1.4};           ///< times the distance from which all is just seen
  std::optional<Within> distance;  ///< in its place, metres
  Within shift{-0.05, 0.05};       ///< how far the middle is off, as a share of the picture's width and height
};

/// What is not given is the style's.
struct DataLight {
  std::optional<Within> azimuth, elevation, strength, ambient, softness;
};

struct DataCamera {
  Within exposure{0, 0};  ///< stops
  Within blur{0, 0};      ///< standard deviation, pixels
  Within noise{0, 0};     ///< standard deviation at white, of the range from black to white
};

/// A picture to stand behind.
struct DataBackground {
  std::filesystem::path file;
  bool is_environment = false;  ///< shows all directions, and lights
};

struct DataGround {
  std::vector<Color> papers;             ///< equally likely; none = the style's
  std::vector<DataBackground> pictures;  ///< those of a folder sorted by name; equally likely
  double share = 1;                      ///< how many pictures have one of them behind
  bool transparent = false;              ///< no ground at all but for the shadow's opacity
};

struct DataDescription {
  std::string file;  ///< for messages
  std::string laws;  ///< the file as JSON, but for what changes no picture: its number, split and words for people
  std::string name, title, description, license, url;
  std::uint64_t seed = 0;
  int count = 0;
  int width = 640, height = 480;
  Quality quality = Quality::draft;
  double detail = 0.5;
  std::vector<std::string> styles{"ink"};  ///< equally likely; paths start at the file's folder
  std::vector<SourcePlace> style_places;   ///< of each that the file names
  DataLayers layers = DataLayers::png;
  DataClasses classes = DataClasses::species;
  int least_area = 1;  ///< pixels; what shows less is no annotation of the set
  bool models = false;
  std::array<double, 3> split{0.8, 0.1, 0.1};  ///< train, validation, test

  WholeLaw fruits{1, 4};
  std::vector<DataArrangement> arrangements{DataArrangement::heap};  ///< equally likely
  Within spread{0.05, 0.1};                                          ///< how far around the middle things fall, metres
  double dish = 0;  ///< how likely things lie in or on one of the dishes
  WholeLaw distractors{0, 0};
  DataView view;
  DataLight light;
  DataCamera camera;
  DataGround ground;
  std::vector<DataDish> dishes;
  std::vector<DataFruit> kinds;
};

constexpr int max_data_pictures = 1'000'000;
constexpr std::array<std::string_view, 3> split_names{"train", "validation", "test"};

/// \throws Error (bad_data) with all errors, also unknown keys, ordered by position.
DataDescription parse_data(std::string_view toml, const std::string& file);

/// The same from disk.
/// \throws Error (input_missing) if it cannot be read.
DataDescription read_data(const std::filesystem::path& file);

/// Pictures to stand behind: each path is a .png, or a folder of these.
struct BackgroundPaths {
  std::vector<std::string> pictures, environments;
};

/// The data with these pictures behind in place of those that its file names, and with laws that say so. None keeps it.
/// \throws Error (input_missing) for a path without a picture, (usage) if the file wants a transparent ground
DataDescription with_backgrounds(DataDescription data, const BackgroundPaths& paths);

/// True for a .toml file with a table [data].
bool is_data_file(const std::filesystem::path& file);

}  // namespace pomona
