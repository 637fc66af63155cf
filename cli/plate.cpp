// pomona plate: a botanical plate of a fruit: whole, cut, its section and a seed.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver/command_report.h"
#include "cli/deliver/watch.h"
#include "cli/options/check_order.h"
#include "cli/options/find_style.h"
#include "cli/options/open_fruit.h"
#include "cli/options/order_options.h"
#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/one_grain.h"
#include "generator/piece/slice.h"
#include "generator/piece/smoothed.h"
#include "generator/scene/lay_out.h"
#include "generator/scene/stand.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/deliver/outside_parts.h"
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
  std::string section = "across";
  std::string half = "half";
  TypedOrder typed;
  Telling telling;
};

/// The figures. A fruit without seeds shows its lengthwise section in their place.
struct PlateContents {
  std::vector<Solid> whole, half;
  CrossSection section, lengthwise;
  std::optional<Solid> seed;
};

/// The fruit cut by one knife.
Slices cut_by(const std::string& knife, const OrderedFruit& fruit, Order order, const Diffuser& diffuser,
              bool section) {
  order.cut.knives = {parse_knife(knife)};
  order.cut.section = section;
  return cut_to_order(fruit, order, &diffuser);
}

PlateContents contents_of(const OrderedFruit& fruit, const PlateCommand& command, const Order& order,
                          CommandReport& report) {
  const std::unique_ptr<Diffuser> diffuser = ordered_diffuser(order, report.told_progress());
  report.times.diffused_by(diffuser->name(), diffuser->device());
  PlateContents contents;
  Slices whole = cut_to_order(fruit, order, nullptr);
  Slices half = cut_by(command.half, fruit, order, *diffuser, false);
  Slices across = cut_by(command.section, fruit, order, *diffuser, true);
  for (const Slices* each : {&whole, &half, &across}) {
    report.times.add(each->times);
    report.warn(each->warnings);
  }
  contents.whole = std::move(whole.pieces);
  contents.half = {std::move(half.pieces.front())};
  contents.section = std::move(across.styled);
  contents.lengthwise = std::move(half.styled);
  contents.seed = one_grain(fruit.grown, fruit.fruit, fruit.name);
  if (contents.seed) contents.seed = smoothed(std::move(*contents.seed), 3);
  return contents;
}

/// The style of a figure: on a sheet of its own, without grain and letters.
Style figure_style(Style style) {
  style.plate.reset();
  style.grain = style.vignette = 0;
  return style;
}

int whole_pixels(double side) { return std::max(static_cast<int>(side), 16); }

constexpr double room_for_soft_shadows = 1.06;  // factor of the field, with room for soft shadows

class FigureMaker {
 public:
  FigureMaker(const Style& style, const PlateSheet& sheet, Threads threads)
      : style_(figure_style(style)), sheet_(sheet), threads_(threads) {}

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

Image plate_of(const PlateContents& contents, const OrderedFruit& source, const Style& style, const PictureSize& size,
               Threads threads) {
  std::vector<std::string> names = parts_in(contents.section, outside_parts(source.fruit));
  const std::vector<std::string>& solid_parts = contents.whole.front().look->part_names;
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
  Order order = read_order(command.typed, {Format::png});
  check_order(order, OrderTaker::plate, command.telling);
  for (const std::string& knife : {command.half, command.section}) parse_knife(knife);
  CommandReport report(command.telling);
  report.warn(idle_options(order, OrderTaker::plate));
  const Style style = find_style(order.color.style.empty() ? "plate" : order.color.style);
  const OrderedFruit fruit = open_fruit(command.fruit, order).grown;
  report.add(fruit);
  const PlateContents contents = contents_of(fruit, command, order, report);
  const PictureSize size = picture_size(order.picture).value_or(PictureSize{1200, 1500});
  Image plate = report.times.time("style", [&] { return plate_of(contents, fruit, style, size, order.threads); });
  plate.dpi = order.picture.dpi;
  Delivered delivered;
  for (const Output& output : order.outputs) delivered.add(output.file, [&] { return write_png(plate); });
  report.add(std::move(delivered));
  write_files(report, order, command.telling);
  return ExitStatus::done;
}

}  // namespace

DeclaredCommand plate_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("plate", "Draw a botanical plate: whole, half, section and seed of one fruit");
  const auto options = std::make_shared<PlateCommand>();
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  command->add_option("--half", options->half, "The knife that halves it for the second figure")
      ->type_name("KNIFE")
      ->capture_default_str();
  command->add_option("--section", options->section, "The knife of the section, whose parts are numbered")
      ->type_name("KNIFE")
      ->capture_default_str();
  add_order_options(*command, OrderTaker::plate, "What to write: .png; - is standard output", options->typed);
  add_telling_options(*command, options->telling);
  return {command, [options] {
            std::vector<std::string> read = options->typed.texts_of("style");
            read.push_back(options->fruit);
            return made_or_watched(options->telling, options->typed.outputs, read,
                                   [&] { return make_plate(*options); });
          }};
}

}  // namespace pomona
