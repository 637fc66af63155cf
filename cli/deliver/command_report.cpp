#include "cli/deliver/command_report.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/deliver/ending_signals.h"
#include "cli/deliver/made_folder.h"
#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "render/export/output.h"

namespace pomona {

namespace {

/// "12.3 MB"; below 0.1 MB "4 kB".
std::string size_in_words(std::size_t bytes) {
  char words[32];
  const double size = static_cast<double>(bytes);
  if (bytes < 100'000)
    std::snprintf(words, sizeof words, "%.0f kB", std::max(size * 1e-3, 1.0));
  else
    std::snprintf(words, sizeof words, "%.1f MB", size * 1e-6);
  return words;
}

void print_as_json(const CommandReport& report) {
  nlohmann::ordered_json result = {{"files", nlohmann::ordered_json::array()}, {"warnings", report.warnings}};
  for (const DeliveredFile& made : report.files)
    result["files"].push_back({{"path", made.file.path.string()}, {"bytes", size_of(made.file)}});
  std::printf("%s\n", json_text(result, 2).c_str());
}

/// Prints the names of files, but only the numbers of maps and ground truth, which may be hundreds.
void print_in_words(CommandReport& report) {
  std::map<std::filesystem::path, std::pair<std::size_t, std::size_t>> folders;  // files and bytes
  for (const DeliveredFile& made : report.files) {
    if (made.is_one_of_many) {
      auto& [files, bytes] = folders[made.file.path.parent_path()];
      ++files;
      bytes += size_of(made.file);
      continue;
    }
    const std::string where = made.file.path == "-" ? "to standard output" : made.file.path.string();
    report.progress.line("wrote " + where + " (" + size_in_words(size_of(made.file)) + ")");
  }
  for (const auto& [folder, what] : folders) {
    const auto& [files, bytes] = what;
    report.progress.line("wrote " + std::to_string(files) + (files == 1 ? " file in " : " files in ") +
                         folder.string() + " (" + size_in_words(bytes) + ")");
  }
  report.progress.line(report.times.summary());
}

}  // namespace

void CommandReport::warn(const std::vector<std::string>& more) {
  for (const std::string& warning : more) progress.line("warning: " + warning);
  warnings.insert(warnings.end(), more.begin(), more.end());
}

void CommandReport::add(const OrderedFruit& fruit) {
  times.add(fruit.times);
  times.count("surface_triangles", static_cast<std::int64_t>(fruit.grown.sheets.triangle_count()));
}

void CommandReport::add(Delivered more) {
  times.add(more.times);
  for (const auto& [what, number] : more.counts) times.count(what, number);
  warn(more.warnings);
  files.insert(files.end(), std::make_move_iterator(more.files.begin()), std::make_move_iterator(more.files.end()));
}

DeliveryProgress CommandReport::told_progress() {
  return [this](const std::string& stage, std::size_t done, std::size_t total) { progress.report(stage, done, total); };
}

void write_files(CommandReport& report, const Order& order, const Telling& telling) {
  std::vector<OutputFile> files;
  for (const DeliveredFile& made : report.files) {
    if (!telling.stats.empty() && is_same_file(made.file.path, telling.stats))
      throw Error(ExitStatus::usage, "--stats " + telling.stats + " is a file of this run already",
                  "give it a name of its own");
  }
  for (DeliveredFile& made : report.files) files.push_back(std::move(made.file));

  // Ctrl-C must not interrupt between two files.
  const HeldSignals held;
  MadeFolder truth(order.picture.aov), maps(order.mesh.maps_dir);
  report.times.time("write", [&] { write_whole(files); });
  truth.keep(), maps.keep();
  for (std::size_t i = 0; i < files.size(); ++i) report.files[i].file = std::move(files[i]);

  // The statistics include the time for writing all other files.
  if (!telling.stats.empty()) {
    report.files.push_back({.file = {telling.stats, report.times.json(resolved(order.threads))}});
    write_whole(std::span(&report.files.back().file, 1));
  }
  if (telling.json) return print_as_json(report);
  print_in_words(report);
}

}  // namespace pomona
