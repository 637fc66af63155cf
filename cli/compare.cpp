// pomona compare: whether two pictures are the same.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/deliver/outputs.h"
#include "cli/options/files_behind.h"
#include "cli/options/option_checks.h"
#include "cli/options/program_folders.h"
#include "cli/sketch/picture_file.h"
#include "generator/base/json_text.h"
#include "generator/base/printable.h"
#include "generator/base/small_ending.h"
#include "render/compare/comparison.h"
#include "render/compare/comparison_page.h"
#include "render/compare/heat_map.h"
#include "render/export/output.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

struct CompareCommand {
  std::string reference, result;
  std::string tolerance = "exact";
  std::optional<int> usual, never;
  std::optional<double> exceptions, flip;
  double pixels_per_degree = FlipOptions{}.pixels_per_degree;
  std::string map, html;
  int threads = 0;
  bool quiet = false;
  bool json = false;
};

Tolerance tolerance_of(const CompareCommand& command) {
  Tolerance tolerance;
  if (command.tolerance == "close") {
    tolerance = close_tolerance;
  }
  tolerance.usual = command.usual.value_or(tolerance.usual);
  tolerance.exceptions = command.exceptions ? *command.exceptions / 100 : tolerance.exceptions;
  tolerance.never = command.never.value_or(tolerance.never);
  tolerance.flip = command.flip.value_or(tolerance.flip);
  return tolerance;
}

/// Refuses a name whose ending says something else than what is written.
void check_ending(const char* option, const std::string& file, const std::string& ending) {
  if (file.empty() || small_ending(file) == ending) return;
  throw Error(ExitStatus::usage, std::string(option) + " " + file + ": it is written as " + ending,
              "give it a name that ends so");
}

/// The requested files; their folders were checked before the work.
std::vector<OutputFile> files(const CompareCommand& command, const ComparedPictures& pictures,
                              const Comparison& comparison, const Tolerance& tolerance) {
  std::vector<OutputFile> result;
  if (!command.map.empty() && !comparison.map.error.empty()) {
    result.push_back({command.map, write_png(heat_map(comparison.map))});
  }
  if (!command.html.empty()) result.push_back({command.html, comparison_page(pictures, comparison, tolerance)});
  return result;
}

void say(const CompareCommand& command, const Comparison& found) {
  const std::size_t pixels = found.map.error.size();
  if (command.json) {
    const nlohmann::ordered_json result = {
        {"same", found.same},     {"largest", found.largest}, {"pixels", pixels},        {"different", found.different},
        {"beyond", found.beyond}, {"flip", found.flip},       {"reasons", found.reasons}};
    std::printf("%s\n", json_text(result, 2).c_str());
    return;
  }
  if (command.quiet) return;
  for (const std::string& reason : found.reasons) std::fprintf(stderr, "%s\n", printable_line(reason).c_str());
  if (pixels > 0) {
    std::printf("%s: mean FLIP %.6f, largest difference %d of 255, %zu of %zu pixels differ\n",
                found.same ? "same" : "different", found.flip, found.largest, found.different, pixels);
  }
}

ExitStatus compare(const CompareCommand& command) {
  const Tolerance tolerance = tolerance_of(command);
  check_ending("--map", command.map, ".png");
  check_ending("--html", command.html, ".html");
  for (const std::string& output : {command.map, command.html}) {
    if (!output.empty()) check_folder(output);
  }
  const fs::path reference_file = existing_file(command.reference), result_file = existing_file(command.result);
  check_not_read({command.map, command.html}, {command.reference, command.result});
  const TransparentImage reference = read_picture(reference_file), result = read_picture(result_file);
  const Comparison found = compared(reference, result, tolerance,
                                    {.pixels_per_degree = command.pixels_per_degree, .threads = {command.threads}});

  const ComparedPictures pictures{.title = result_file.filename().string(),
                                  .reference_name = reference_file.filename().string(),
                                  .result_name = result_file.filename().string(),
                                  .reference = reference,
                                  .result = result};
  write_whole(files(command, pictures, found, tolerance));
  say(command, found);
  return found.same ? ExitStatus::done : ExitStatus::some_items_failed;
}

}  // namespace

DeclaredCommand compare_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("compare", "Tell whether two pictures are the same: status 0 or 1");
  const auto options = std::make_shared<CompareCommand>();

  // Two pictures, and their allowed difference.
  command->add_option("REFERENCE", options->reference, "A picture (.png) as it should be")->required();
  command->add_option("RESULT", options->result, "The picture to look at")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "exact (the default), or close: what OpenGL's drivers and POV-Ray may differ by")
      ->check(one_of({"exact", "close"}));
  command->add_option("--usual", options->usual, "Difference, of 255, that any pixel may have")
      ->check(whole_between(0, 255));
  command->add_option("--exceptions", options->exceptions, "Percentage of pixels that may differ by more")
      ->check(between(0.0, 100.0));
  command->add_option("--never", options->never, "Difference, of 255, that no pixel may exceed")
      ->check(whole_between(0, 255));

  // FLIP compares them as the eye does; its map shows the differences.
  command->add_option("--flip", options->flip, "Largest mean FLIP, 0 to 1")->check(between(0.0, 1.0));
  command->add_option("--ppd", options->pixels_per_degree, "Pixels per degree of the eye's field; the default is 67")
      ->check(between(5.0, 500.0));
  command->add_option("--map", options->map, "Write FLIP's map as a picture (.png)")->type_name("FILE");
  command->add_option("--html", options->html, "Write a page that shows both, and the map")->type_name("FILE");

  // How it runs, and what it prints.
  command->add_option("--threads", options->threads, "Threads to use; 0 = all there are")
      ->check(whole_between(0, 1024));
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->add_flag("--json", options->json, "Print the figures as JSON");
  return {command, [options] { return compare(*options); }};
}

}  // namespace pomona
