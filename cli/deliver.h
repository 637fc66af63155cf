// From finished values to files: the last stretch that grow, cut and scene share.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/ripeness_variants.h"
#include "cli/shared_options.h"
#include "cli/stage_times.h"
#include "cli/streamed_glb.h"
#include "generator/scene/scene.h"
#include "render/export/output.h"
#include "render/export/styled_mesh.h"
#include "render/export/svg.h"
#include "render/export/texture_variant.h"
#include "render/plate/plate.h"
#include "render/style/style.h"
#include "render/texture/bake.h"

namespace pomona {

/// OpenGL draws pieces with two samples to each side of a pixel, which bounds the size of their pictures: told before
/// anything is grown. \throws Error (usage).
void check_picture_size(const SharedOptions& options, const std::vector<Output>& outputs);

/// \throws Error (usage) if something is asked for that no output holds, or that does not go together.
void check_exports(const SharedOptions& options, const std::vector<Output>& outputs);

/// Collects a command's outputs and writes them together: all of them appear, or none.
class Delivery {
 public:
  /// \throws Error (usage) for a style, size, texel or view that is not one.
  explicit Delivery(const SharedOptions& options);

  /// Makes the bytes of one file (stage "write") and keeps them until finish().
  void add(const std::filesystem::path& file, const std::function<std::string()>& make);

  /// Of pictures when --style says nothing: a name, or a path. \throws Error as find_style()
  void set_default_style(const std::string& name_or_path);

  /// What a plate says in pictures of solids; without it none is made of them.
  void set_plate_text(PlateText text) { plate_text_ = std::move(text); }

  /// Of .glb with textures: the same solids at other ripenesses.
  void set_variants(std::vector<RipenessVariant> variants) { variants_ = std::move(variants); }

  const Style& style() const { return style_; }

  /// All that will be added, for what several of them share: levels of detail, and textures.
  void set_outputs(const std::vector<Output>& outputs);

  /// For a scene whose outputs do not need all of it at once: takes its solids as they are made (make_parts.h), and
  /// writes them on their way to the .glb files; add() then finishes these. Empty where other outputs need the solids.
  /// After set_outputs() and set_default_style().
  std::function<void(std::span<const Solid> solids)> taker();

  /// A scene as .ply, .glb, .pov (with its includes), .png or .svg.
  void add(const Output& output, const Scene& scene);

  /// A section as .png or .svg.
  void add_section_picture(const Output& output, const CrossSection& section, const Template& fruit);

  /// Of pictures when --size says nothing.
  void set_default_size(PictureSize size) { default_size_ = size; }

  /// Width over height of pictures.
  double picture_aspect() const;

  /// What ground truth says of the picture; --seed unless this is called.
  void set_seed(std::uint64_t seed) { seed_ = seed; }

  void warn(const std::vector<std::string>& warnings);

  /// Puts everything on disk, --stats included, and says what was written.
  void finish();

  StageTimes times;
  Progress progress;

 private:
  void add_picture(const Output& output, const Scene& scene);
  void add_ground_truth(const Output& picture, const Scene& seen, const PictureSize& size);
  SvgMarks marks_on(const Scene& seen, const PictureSize& size) const;
  void add_lines(const Output& output, const Scene& scene);
  void add_pov(const Output& output, const Scene& scene);
  static std::vector<PlateLayer> plate_layers(const std::optional<Plate>& plate, const Scene& seen,
                                              const PictureSize& size);
  std::optional<Plate> plate_for(const Scene& scene, const PictureSize& size) const;
  Scene fitted(Scene scene, const PictureSize& size, const std::optional<Plate>& plate) const;
  /// A scene's solids with their colours in textures.
  struct BakedScene {
    std::vector<BakedSolid> solids;
    std::vector<std::vector<BakedSolid>> coarser;
    std::vector<TextureVariant> variants;
  };
  /// What files of meshes with levels or textures are made of, made once for all of them.
  struct ReadyMeshes {
    const Solid* of = nullptr;  ///< the scene's first solid
    std::vector<std::vector<Solid>> levels;
    BakedScene baked;
  };
  std::shared_ptr<const ReadyMeshes> ready_meshes(const Scene& scene);
  BakedScene baked_scene(const Scene& scene, std::span<const std::vector<Solid>> levels);
  std::optional<BakeOptions> bake_options() const;
  void add_usda(const Output& output, const Scene& scene);
  void add_glb(const Output& output, const Scene& scene);
  std::vector<std::vector<Solid>> levels_of(const Scene& scene);
  void finish_glb(StreamedGlb& stream, const Scene& scene);
  /// A file of a folder that holds many: the last lines say how many.
  void add_counted(OutputFile file);
  void say_what_was_written();

  ExportOptions export_options() const;
  std::string command_words() const;

  const SharedOptions& options_;
  Style style_;
  std::vector<RipenessVariant> variants_;
  std::vector<Output> outputs_;
  std::vector<std::unique_ptr<StreamedGlb>> streams_;
  std::shared_ptr<const ReadyMeshes> ready_;
  std::ptrdiff_t uses_left_ = 0;  ///< of ready_
  std::string style_word_;        ///< what names it; empty = the default
  std::optional<PlateText> plate_text_;
  PictureSize default_size_{960, 720};
  std::optional<PictureSize> size_;
  std::optional<glm::dvec3> view_;
  double texel_;
  std::uint64_t seed_;
  std::vector<OutputFile> files_;
  std::set<std::filesystem::path> counted_;  // of these
  std::vector<std::string> warnings_;
};

}  // namespace pomona
