// pomona plate: a fruit as a botanical plate shows it, whole, cut, in section and with a seed.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/diffusers.h"
#include "cli/fruit_source.h"
#include "cli/option_checks.h"
#include "cli/outputs.h"
#include "cli/outside_parts.h"
#include "cli/watch.h"
#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/one_grain.h"
#include "generator/piece/slice.h"
#include "generator/piece/smoothed.h"
#include "generator/scene/lay_out.h"
#include "generator/scene/stand.h"
#include "render/gl/context.h"
#include "render/gl/scene_picture.h"
#include "render/image/png.h"
#include "render/picture/light_direction.h"
#include "render/picture/plate_sheet.h"
#include "render/picture/section_parts.h"
#include "render/picture/section_picture.h"
#include "render/picture/view_within.h"
#include "render/strokes/scene_parts.h"

namespace pomona {

namespace {

struct PlateCommand {
  std::string fruit;
  std::vector<std::string> outputs;
  std::optional<int> folds;
  std::string section = "across";
  std::string half = "half";
  SharedOptions shared;
};

/// What the figures show. Where the fruit has no seed of its own to show, its lengthwise section takes that place.
struct PlateContents {
  std::vector<Solid> whole, half;
  CrossSection section, lengthwise;
  std::optional<Solid> seed;
};

Slices sliced(const FruitSource& source, const std::string& knife, const Diffuser& diffuser, bool pieces,
              const PlateCommand& command) {
  const std::vector<Knife> knives{parse_knife(knife)};
  const Threads threads{command.shared.threads};
  return sliced(source, slice_task(source, knives, 0), &diffuser,
                {.cut = {.threads = threads}, .pieces = pieces, .threads = threads});
}

PlateContents contents_of(const FruitSource& source, const PlateCommand& command, Delivery& delivery) {
  const std::unique_ptr<Diffuser> diffuser = make_diffuser(command.shared, delivery.progress);
  delivery.times.diffused_by(diffuser->name(), diffuser->device());
  PlateContents contents;
  Slices whole = sliced(source, slice_task(source, {}, 0), nullptr);
  Slices half = sliced(source, command.half, *diffuser, true, command);
  Slices across = sliced(source, command.section, *diffuser, false, command);
  for (const Slices* each : {&whole, &half, &across}) {
    delivery.times.add(each->times);
    delivery.warn(each->warnings);
  }
  contents.whole = std::move(whole.pieces);
  contents.half = {std::move(half.pieces.front())};
  contents.section = std::move(across.styled);
  contents.lengthwise = std::move(half.styled);
  contents.seed = one_grain(source.grown, source.fruit, source.name);
  if (contents.seed) contents.seed = smoothed(std::move(*contents.seed), 3);
  return contents;
}

/// The style of a figure: on a sheet of its own colour, without grain and letters of its own.
Style figure_style(Style style) {
  style.plate.reset();
  style.grain = style.vignette = 0;
  return style;
}

int whole_pixels(double side) { return std::max(static_cast<int>(side), 16); }

constexpr double room_for_soft_shadows = 1.06;  // times the field that holds what casts them

class FigureMaker {
 public:
  FigureMaker(const Style& style, const PlateSheet& sheet, int threads)
      : style_(figure_style(style)), sheet_(sheet), threads_{threads} {}

  /// Solids on the table, or in the air, seen from a direction.
  SheetFigure of_scene(Scene scene, const glm::dvec3& direction, std::size_t room) {
    const glm::ivec2 size = size_of(room);
    scene.paper = style_.paper;
    std::optional<glm::dvec3> light;
    if (scene.ground) light = light_direction(View{.eye = direction, .target = glm::dvec3(0)}, style_.light);
    scene.view = fitted_view(scene, direction, static_cast<double>(size.x) / size.y, light);
    scene.view.vertical_field *= room_for_soft_shadows;
    return {draw_scene(context_, scene, style_, {.width = size.x, .height = size.y, .samples = 9, .threads = threads_}),
            scene_parts(scene, size.x, size.y), pixels_per_metre(scene.view, size.y)};
  }

  SheetFigure of_section(const CrossSection& section, const Template& fruit, std::size_t room) {
    const glm::ivec2 size = size_of(room);
    const SectionPictureOptions options{.width = size.x, .height = size.y, .threads = threads_};
    const SectionSheet paper(section, style_, options);
    PartMap parts = section_parts(section, paper.faces(), size.x, size.y);
    add_rims(parts, section, paper.faces(), outside_parts(fruit));
    const double scale = paper.faces().empty() ? 0 : paper.faces().front().scale;
    return {draw_section(section, Look(fruit.noise, fruit.details), fruit.ink, style_, options), std::move(parts),
            scale};
  }

 private:
  glm::ivec2 size_of(std::size_t room) const {
    const PlateBox& box = sheet_.rooms()[room];
    return {whole_pixels(box.high.x - box.low.x), whole_pixels(box.high.y - box.low.y)};
  }

  Style style_;
  const PlateSheet& sheet_;
  Threads threads_;
  GlContext context_;
};

Image plate_of(const PlateContents& contents, const FruitSource& source, const Style& style, const PictureSize& size,
               int threads) {
  std::vector<std::string> names = parts_in(contents.section, outside_parts(source.fruit));
  const std::vector<std::string>& solid_parts = contents.whole.front().part_names;
  names.insert(names.end(), solid_parts.begin(), solid_parts.end());
  const PlateSheet sheet(style, {source.fruit.title, source.fruit.latin}, names, 4, size.width, size.height);
  FigureMaker maker(style, sheet, threads);

  std::vector<SheetFigure> drawn;
  drawn.push_back(maker.of_scene(standing(gathered(contents.whole)), {0.35, 0.62, 1}, 0));
  drawn.push_back(maker.of_scene(laid_out(gathered(contents.half)), {0.42, 0.45, 0.8}, 1));
  drawn.push_back(maker.of_section(contents.section, source.fruit, 2));
  drawn.push_back(contents.seed ? maker.of_scene(laid_out(gathered({*contents.seed})), {0.3, 0.8, 0.6}, 3)
                                : maker.of_section(contents.lengthwise, source.fruit, 3));
  return sheet.drawn(drawn);
}

ExitStatus make_plate(const PlateCommand& command) {
  const std::vector<Output> outputs = parse_outputs(command.outputs, {Format::png}, command.shared.format);
  check_exports(command.shared, outputs);
  check_other_files(command.shared, outputs);
  for (const std::string& knife : {command.half, command.section}) parse_knife(knife);
  SharedOptions shared = command.shared;
  if (shared.style.empty()) shared.style = "plate";
  Delivery delivery(shared);
  delivery.warn(idle_options(shared, outputs));
  const FruitSource source = open_fruit(command.fruit, shared, command.folds, delivery.times);
  const PlateContents contents = contents_of(source, command, delivery);
  const PictureSize size = picture_size(shared).value_or(PictureSize{1200, 1500});
  Image plate =
      delivery.times.time("style", [&] { return plate_of(contents, source, delivery.style(), size, shared.threads); });
  plate.dpi = shared.dpi;
  for (const Output& output : outputs) delivery.add(output.file, [&] { return write_png(plate); });
  delivery.finish();
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand plate_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("plate", "Draw a botanical plate: whole, half, section and seed of one fruit");
  const auto options = std::make_shared<PlateCommand>();
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  add_output_option(*command, options->outputs, "What to write: .png; - is standard output");
  command->add_option("--half", options->half, "The knife that halves it for the second figure")
      ->type_name("KNIFE")
      ->capture_default_str();
  command->add_option("--section", options->section, "The knife of the section, whose parts are numbered")
      ->type_name("KNIFE")
      ->capture_default_str();
  command->add_option("--folds", options->folds, "Another number of folds than drawn")->check(whole_between(1, 64));
  add_index_options(*command, options->shared);
  add_ripeness_option(*command, options->shared);
  add_browning_option(*command, options->shared);
  add_plate_options(*command, options->shared);
  return {command, [options] {
            return made_or_watched(options->shared, options->outputs, {options->fruit, options->shared.style},
                                   [&] { return make_plate(*options); });
          }};
}

}  // namespace pomona
