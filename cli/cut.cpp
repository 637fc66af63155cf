// pomona cut: a fruit's pieces, or the bare section.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/deliver.h"
#include "cli/diffusers.h"
#include "cli/family.h"
#include "cli/fruit_source.h"
#include "cli/live_fruit.h"
#include "cli/option_checks.h"
#include "cli/outputs.h"
#include "cli/piece_list.h"
#include "cli/ripeness_variants.h"
#include "cli/still_at_work.h"
#include "cli/watch.h"
#include "generator/base/error.h"
#include "generator/cut/section/section_file.h"
#include "generator/knife/knife_kinds.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "generator/scene/explode.h"
#include "generator/scene/lay_out.h"
#include "generator/scene/stand.h"

namespace pomona {

namespace {

struct CutCommand {
  std::string fruit;
  std::vector<std::string> knives;
  std::vector<std::string> outputs;
  std::optional<int> folds;
  bool section = false;
  double explode = 1;
  bool crumbs = false;
  std::string pieces;
  int piece = 0;
  std::string seeds;
  std::string faces = "fine";
  SharedOptions shared;
};

/// A bare section has no solid to put into a scene format.
std::vector<Format> formats_for(const CutCommand& command) {
  if (command.section) return {Format::ply, Format::png, Format::svg};
  return {Format::ply, Format::glb, Format::usda, Format::obj,  Format::stl,
          Format::pov, Format::png, Format::svg,  Format::html, Format::pomona};
}

/// The section's file keeps what was diffused; its pictures show what pieces show.
void write_section_files(const std::vector<Output>& outputs, const Slices& slices, const Template& fruit,
                         Delivery& delivery) {
  for (const Output& output : outputs) {
    if (output.format == Format::ply) {
      delivery.add(output.file, [&] { return write_section(slices.section); });
    } else {
      delivery.add_section_picture(output, slices.styled, fruit);
    }
  }
}

void write_piece_files(const CutCommand& command, const std::vector<Output>& outputs, std::vector<Solid> pieces,
                       Delivery& delivery) {
  Scene in_place = gathered(std::move(pieces));
  in_place.paper = delivery.style().paper;
  if (!command.pieces.empty()) delivery.add(command.pieces, [&] { return piece_list(in_place); });
  const bool apart = command.explode > 1;
  const Scene moved = apart ? exploded(in_place, command.explode) : in_place;
  for (const Output& output : outputs) {
    if (is_live(output.format)) continue;
    // A picture of pieces in their place would show a whole fruit: lay them out side by side.
    const bool is_picture = output.format == Format::png || output.format == Format::svg;
    // Of pieces moved apart the lowest stands on the table.
    if (!is_picture) {
      delivery.add(output, moved);
    } else {
      delivery.add(output, apart ? standing(moved) : laid_out(in_place, delivery.picture_aspect()));
    }
  }
}

void count(const Slices& slices, StageTimes& times) {
  const CrossSection& section = slices.section;
  times.count("interior_vertices", std::count(section.interior.begin(), section.interior.end(), 1));
  times.count("section_vertices", static_cast<std::int64_t>(section.position.size()));
  times.count("section_triangles", static_cast<std::int64_t>(section.triangle.size()));
  times.count("pieces", static_cast<std::int64_t>(slices.piece_count));
}

SliceOptions slice_options(const CutCommand& command) {
  CutOptions how = command.faces == "coarse" ? coarse_cut : CutOptions{};
  how.threads = {command.shared.threads};
  return {.cut = how,
          .pieces = !command.section,
          .keep_section_colors = wants_textures(command.shared),
          .threads = {command.shared.threads}};
}

Slices cut_up(const FruitSource& source, const CutCommand& command, std::span<const Knife> knives,
              const Diffuser& diffuser, Delivery& delivery) {
  SliceTask task = slice_task(source, knives, command.piece);
  task.crumbs = command.crumbs;
  const auto slices_of_task = [&] {
    // Most cuts take parts of a second, a narrow strip of peel a minute.
    const StillAtWork still(delivery.progress, "cutting");
    return sliced(source, task, &diffuser, slice_options(command));
  };
  Slices slices = slices_of_task();
  check_piece(command.piece, slices);
  delivery.times.add(slices.times);
  delivery.warn(slices.warnings);
  return slices;
}

/// The pieces of each seed's fruit, side by side.
ExitStatus cut_family(const CutCommand& command, std::span<const Knife> knives, const std::vector<Output>& outputs,
                      const Diffuser& diffuser, Delivery& delivery) {
  check_family(command.shared, outputs);
  if (command.section || command.explode > 1 || !command.pieces.empty() || any_live(outputs)) {
    throw Error(ExitStatus::usage, "--seeds does not go with --section, --explode, --pieces and .html",
                "leave them out; `pomona grow --seeds` makes pages");
  }
  std::vector<Solid> solids;
  for (const SharedOptions& one : each_seed(command.seeds, command.shared)) {
    const FruitSource source = open_fruit(command.fruit, one, command.folds, delivery.times);
    Slices slices = cut_up(source, command, knives, diffuser, delivery);
    std::vector<Solid> own = named_by_seed(std::move(slices.pieces), one.seed);
    solids.insert(solids.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  add_row(std::move(solids), outputs, delivery);
  delivery.finish();
  return ExitStatus::done;
}

/// As idle_options(), of what cut alone has.
std::vector<std::string> idle_cut_options(const CutCommand& command, const std::vector<Output>& outputs) {
  std::vector<std::string> warnings = idle_options(command.shared, outputs);
  const auto add = [&](std::vector<std::string> more) { warnings.insert(warnings.end(), more.begin(), more.end()); };
  add(idle_variant_options(command.shared, command.seeds));
  if (command.section && !command.shared.view.empty()) add({"--view: a section is looked at straight"});
  if (command.section && command.crumbs) add({"--crumbs is about pieces: a section has none"});
  const bool is_asked = command.explode > 1 || command.crumbs || command.piece > 0 || command.faces != "fine";
  if (is_asked && all_live(outputs))
    add({"--explode, --crumbs, --piece and --faces have no effect on .html and .pomona: these hold the whole fruit"});
  return warnings;
}

ExitStatus cut_fruit(const CutCommand& command) {
  // Everything that can be wrong with the words is told before the work begins.
  std::vector<Knife> knives;
  for (const std::string& text : command.knives) knives.push_back(parse_knife(text));
  const std::vector<Output> outputs = parse_outputs(command.outputs, formats_for(command), command.shared.format);
  check_exports(command.shared, outputs);
  if (!command.section) check_picture_size(command.shared, outputs);
  check_aov(command.shared.aov, outputs);
  if (any_live(outputs)) check_live_knives(knives);
  if (command.section &&
      (command.explode > 1 || command.piece > 0 || !command.pieces.empty() || !command.shared.aov.empty())) {
    throw Error(ExitStatus::usage, "--explode, --piece, --pieces and --aov are about pieces: leave out --section");
  }
  check_other_files(command.shared, outputs, command.pieces);
  Delivery delivery(command.shared);
  delivery.set_outputs(outputs);
  delivery.warn(idle_cut_options(command, outputs));
  const std::unique_ptr<Diffuser> diffuser = make_diffuser(command.shared, delivery.progress);
  delivery.times.diffused_by(diffuser->name(), diffuser->device());

  if (!command.seeds.empty()) return cut_family(command, knives, outputs, *diffuser, delivery);
  const FruitSource source = open_fruit(command.fruit, command.shared, command.folds, delivery.times);
  delivery.set_plate_text({source.fruit.title, source.fruit.latin});
  add_live(outputs, source, knives, command.shared, delivery);
  if (all_live(outputs) && command.pieces.empty()) {
    delivery.finish();
    return ExitStatus::done;
  }
  Slices slices = cut_up(source, command, knives, *diffuser, delivery);
  count(slices, delivery.times);
  delivery.set_variants(ripeness_variants(slices.pieces, source, command.fruit, command.shared, command.folds,
                                          diffuser.get(), delivery.times));
  if (command.section) {
    write_section_files(outputs, slices, source.fruit, delivery);
  } else {
    write_piece_files(command, outputs, std::move(slices.pieces), delivery);
  }
  delivery.finish();
  return ExitStatus::done;
}

std::vector<std::string> written_by(const CutCommand& command) {
  std::vector<std::string> names = command.outputs;
  names.push_back(command.pieces);
  return names;
}

/// What it reads by the words of the line.
std::vector<std::string> read_by(const CutCommand& command) {
  std::vector<std::string> words = command.knives;
  words.insert(words.end(), {command.fruit, command.shared.style});
  return words;
}

}  // namespace

DeclaredCommand cut_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("cut", "Cut a fruit into pieces, or show the bare section");
  const auto options = std::make_shared<CutCommand>();

  // What is cut, along what, and into which files.
  command->add_option("TEMPLATE", options->fruit, "A name from `pomona list`, a template file or a surface file (.ply)")
      ->required();
  command->add_option("--knife", options->knives, "One of those below; several cut one after another")
      ->type_name("KNIFE")
      ->required()
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_output_option(
      *command, options->outputs,
      "What to write: .ply, .glb, .usda, .obj, .stl, .pov, .png, .svg, .html or .pomona; - is standard output");

  // What to make of the cut.
  command->add_option("--folds", options->folds, "Another number of folds than drawn")->check(whole_between(1, 64));
  command->add_flag("--section", options->section, "The bare section instead of pieces (.ply, .png or .svg)");
  command->add_option("--explode", options->explode, "Move pieces apart: their distance from the middle times this")
      ->check(between(1.0, 10.0));
  command->add_flag("--crumbs", options->crumbs, "Keep bits below a millionth of the fruit as pieces of their own");
  command->add_option("--piece", options->piece, "This piece alone, as numbered in the order of cutting")
      ->check(whole_between(1, 1000000));
  command->add_option("--faces", options->faces, "How finely cut faces are triangulated; scenes have coarse ones")
      ->check(one_of({"fine", "coarse"}))
      ->capture_default_str();
  command->add_option("--pieces", options->pieces, "Also write what there is to know of each piece to this file (JSON)")
      ->type_name("FILE");

  // Options that other commands have too.
  add_index_options(*command, options->shared);
  add_ripeness_option(*command, options->shared);
  add_ripeness_variants_option(*command, options->shared);
  add_browning_option(*command, options->shared);
  add_shared_options(*command, options->shared);
  add_seeds_option(*command, options->seeds);
  add_watch_option(*command, options->shared);
  command->footer("Knives, and along what they cut:\n" + knife_help());
  return {command, [options] {
            return made_or_watched(options->shared, written_by(*options), read_by(*options),
                                   [&] { return cut_fruit(*options); });
          }};
}

}  // namespace pomona
