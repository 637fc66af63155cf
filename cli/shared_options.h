// The options that several commands share (docs/reference/commands.md), from the words typed to values checked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/parallel.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

struct PictureSize {
  int width = 0, height = 0;
};

struct SharedOptions {
  std::uint64_t seed = 0;
  bool seed_given = false;
  std::optional<std::uint64_t> index;  ///< of the variant in its scene; for commands that grow one fruit
  double scale = 1;
  bool as_drawn = false;  ///< likewise
  double variation = 1.0;
  bool curves_only = false;
  int threads = 0;
  std::string diffuser = "cpu";
  bool diffuser_given = false;
  std::string quality = "final";
  double detail = 1.0;
  std::string style;         ///< name or path; none = what the scene says, or ink
  int texture = 0;           ///< texels along an atlas's edge; 0 = not said
  std::string texel;         ///< size of a texel, with its unit
  std::string maps = "all";  ///< "color" or "all": what textures hold
  std::string maps_dir;      ///< folder for them as pictures, too; none = not wanted
  int lod = 0;               ///< further levels of detail
  std::string engine;        ///< "godot", "unreal" or "unity"
  bool instances = false;    ///< what repeats as one node with many places
  bool feature_ids = false;  ///< parts as EXT_mesh_features, too
  std::string size;
  double dpi = 0;  ///< of pictures on paper, pixels per inch; 0 = not said
  std::string view;
  std::string stats;
  std::string format;  ///< of standard output, where an output is "-"
  bool quiet = false;
  bool json = false;
  bool watch = false;  ///< make the outputs anew when a file that was read changes
  std::string aov;     ///< folder for the ground truth of the picture; none = not wanted
  std::string aov_format = "png";
  std::string ripeness_variants;   ///< "0.3,1,1.7"
  std::optional<double> ripeness;  ///< of one fruit; scenes say it in their file
  double browning = 0;
};

/// -o, once or several times. \param what the help's words: "What to write: .png". `outputs` must outlive the parsing.
void add_output_option(CLI::App& command, std::vector<std::string>& outputs, const std::string& what);

/// Declares what grow, cut and scene share. `options` must outlive the parsing.
void add_shared_options(CLI::App& command, SharedOptions& options);

/// Of these what a plate heeds: no meshes, no textures, no views.
void add_plate_options(CLI::App& command, SharedOptions& options);

/// --index and --as-drawn, for commands that grow one fruit.
void add_index_options(CLI::App& command, SharedOptions& options);

/// --ripeness, for commands that grow one fruit.
void add_ripeness_option(CLI::App& command, SharedOptions& options);

/// --ripeness-variants, for commands that write meshes of one fruit.
void add_ripeness_variants_option(CLI::App& command, SharedOptions& options);

/// --browning, for commands that cut one.
void add_browning_option(CLI::App& command, SharedOptions& options);

/// --watch, for commands that write files.
void add_watch_option(CLI::App& command, SharedOptions& options);

/// "800x600", or with --dpi "120x90mm"; 16..16384 pixels a side. Nothing if none was asked for. \throws Error (usage)
std::optional<PictureSize> picture_size(const SharedOptions& options);

/// Whether colours are to be baked into textures.
bool wants_textures(const SharedOptions& options);

/// --texel in metres, 0 if it was not said. \throws Error (usage)
double texel_size(const SharedOptions& options);

/// Direction from the fruit to the eye: "front", "back", "left", "right", "top", "bottom", "three-quarter", or
/// "AZIMUTH,ELEVATION" in degrees (azimuth from +Z, the front, towards +X). Nothing if none was asked for. \throws
/// Error (usage)
std::optional<glm::dvec3> view_direction(const SharedOptions& options);

}  // namespace pomona
