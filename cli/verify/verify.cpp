// pomona verify: whether this machine gives the numbers and files that are published.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/deliver/outputs.h"
#include "cli/deliver/progress.h"
#include "cli/options/find_template.h"
#include "cli/options/option_checks.h"
#include "cli/verify/hash_table.h"
#include "cli/verify/stage_hashes.h"
#include "generator/base/json_text.h"
#include "generator/base/nearest_name.h"
#include "generator/template/read/read_template.h"
#include "render/export/output.h"

namespace pomona {

namespace {

struct VerifyCommand {
  std::vector<std::string> fruits;
  bool all = false;
  std::string table;
  std::string output;
  int threads = 0;
  bool quiet = false;
  bool json = false;
};

/// A cut that differs from the table.
struct DifferentCut {
  VerifiedCut cut;
  std::size_t stage = 0;  ///< first stage that differs
};

/// The program's own templates, by name; those of the current folder are not published.
std::map<std::string, std::filesystem::path> published_templates() {
  std::map<std::string, std::filesystem::path> files;
  for (const auto& file : all_templates()) files.emplace(file.stem().string(), file);
  return files;
}

/// The table beside the templates.
std::filesystem::path published_table() {
  for (const auto& folder : program_folders("templates")) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(folder / "hashes.txt", ignored)) return folder / "hashes.txt";
  }
  throw Error(ExitStatus::input_missing, "there is no table of hashes", "looked for hashes.txt beside the templates");
}

/// The cuts of these fruits, in the table's order.
/// \throws Error (input_missing) for a fruit that has none.
std::vector<VerifiedCut> wanted_cuts(const VerifyCommand& command, const std::vector<VerifiedCut>& known) {
  std::vector<std::string> names;
  for (const VerifiedCut& cut : known) names.push_back(cut.fruit);
  for (const std::string& fruit : command.fruits) {
    if (std::find(names.begin(), names.end(), fruit) != names.end()) continue;
    const auto near = nearest_name(fruit, names);
    throw Error(ExitStatus::input_missing, "no hashes of \"" + fruit + "\" are published",
                near ? "did you mean " + *near + "?" : "`pomona list` names the templates");
  }
  std::vector<VerifiedCut> wanted;
  for (const VerifiedCut& cut : known) {
    const bool named = std::find(command.fruits.begin(), command.fruits.end(), cut.fruit) != command.fruits.end();
    if ((command.all || in_the_tenth(cut)) && (named || command.fruits.empty())) wanted.push_back(cut);
  }
  return wanted;
}

/// All cuts of a table of these templates.
std::vector<VerifiedCut> all_cuts(const std::map<std::string, std::filesystem::path>& templates) {
  std::vector<VerifiedCut> cuts;
  for (const auto& [name, file] : templates)
    for (std::uint64_t seed = 0; seed < verified_seeds; ++seed)
      for (const char* knife : verified_knives) cuts.push_back({name, seed, knife});
  return cuts;
}

/// Makes each cut: variants in parallel, and each on this number of threads.
HashTable made_hashes(const std::vector<VerifiedCut>& cuts,
                      const std::map<std::string, std::filesystem::path>& templates, Threads threads,
                      Progress& progress) {
  // One variant with several knives grows once.
  std::map<std::pair<std::string, std::uint64_t>, std::vector<std::string>> knives;
  for (const VerifiedCut& cut : cuts) knives[{cut.fruit, cut.seed}].push_back(cut.knife);
  const std::vector variants(knives.begin(), knives.end());
  std::vector<std::vector<StageHashes>> hashes(variants.size());
  std::atomic<std::size_t> done = 0;
  const auto count = [&] { progress.report("verify", ++done, cuts.size()); };
  parallel_for(variants.size(), threads, [&](std::size_t i) {
    const auto& [name, seed] = variants[i].first;
    const auto file = templates.find(name);
    if (file == templates.end())
      throw Error(ExitStatus::input_missing, "there is no template \"" + name + "\", of which hashes are published",
                  where_looked("templates"));
    hashes[i] = stage_hashes(read_template(file->second), seed, variants[i].second, threads, count);
  });

  HashTable table;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const auto& [name, seed] = variants[i].first;
    for (std::size_t k = 0; k < variants[i].second.size(); ++k)
      table[{name, seed, variants[i].second[k]}] = hashes[i][k];
  }
  return table;
}

std::vector<DifferentCut> differences(const HashTable& published, const HashTable& made) {
  std::vector<DifferentCut> different;
  for (const auto& [cut, hashes] : made) {
    const StageHashes& wanted = published.at(cut);
    const auto [there, here] = std::mismatch(wanted.begin(), wanted.end(), hashes.begin());
    if (there != wanted.end()) different.push_back({cut, static_cast<std::size_t>(there - wanted.begin())});
  }
  return different;
}

void say_as_json(std::size_t compared, std::size_t published, const std::vector<DifferentCut>& different) {
  nlohmann::ordered_json cuts = nlohmann::ordered_json::array();
  for (const auto& [cut, stage] : different)
    cuts.push_back(
        {{"template", cut.fruit}, {"seed", cut.seed}, {"knife", cut.knife}, {"stage", verified_stages[stage]}});
  const nlohmann::ordered_json result = {
      {"same", different.empty()}, {"compared", compared}, {"published", published}, {"different", cuts}};
  std::printf("%s\n", json_text(result, 2).c_str());
}

void say_in_words(std::size_t compared, std::size_t published, const std::vector<DifferentCut>& different) {
  constexpr std::size_t max_lines = 20;
  for (std::size_t i = 0; i < std::min(max_lines, different.size()); ++i) {
    const auto& [cut, stage] = different[i];
    std::printf("%s, seed %llu, %s: differs from %s on\n", cut.fruit.c_str(), static_cast<unsigned long long>(cut.seed),
                cut.knife.c_str(), verified_stages[stage]);
  }
  if (different.size() > max_lines) std::printf("and %zu more\n", different.size() - max_lines);
  if (different.empty()) {
    std::printf("%zu of %zu cuts compared, 0 differ: this machine gives what is published.\n", compared, published);
    return;
  }
  const auto first = std::min_element(different.begin(), different.end(),
                                      [](const auto& a, const auto& b) { return a.stage < b.stage; });
  std::printf("%zu of %zu cuts compared, %zu differ: this machine does not give what is published, from %s on.\n",
              compared, published, different.size(), verified_stages[first->stage]);
}

ExitStatus write_table(const VerifyCommand& command, Progress& progress) {
  check_folder(command.output);
  const auto templates = published_templates();
  const std::vector<VerifiedCut> wanted = wanted_cuts(command, all_cuts(templates));
  HashTable made = made_hashes(wanted, templates, {command.threads}, progress);
  std::erase_if(made, [](const auto& entry) { return entry.second.back().empty(); });  // removes cuts that cannot be
                                                                                       // made
  write_whole(command.output, write_hash_table(made));
  if (!command.quiet) std::printf("%s: hashes of %zu cuts\n", command.output.c_str(), made.size());
  return ExitStatus::done;
}

ExitStatus verify(const VerifyCommand& command) {
  Progress progress(command.quiet);
  if (!command.output.empty()) return write_table(command, progress);
  const HashTable published = read_hash_table(command.table.empty() ? published_table() : existing_file(command.table));
  std::vector<VerifiedCut> known;
  for (const auto& [cut, hashes] : published) known.push_back(cut);
  const std::vector<VerifiedCut> wanted = wanted_cuts(command, known);
  const HashTable made = made_hashes(wanted, published_templates(), {command.threads}, progress);
  const std::vector<DifferentCut> different = differences(published, made);
  if (command.json) {
    say_as_json(made.size(), published.size(), different);
  } else if (!command.quiet) {
    say_in_words(made.size(), published.size(), different);
  }
  return different.empty() ? ExitStatus::done : ExitStatus::some_items_failed;
}

}  // namespace

DeclaredCommand verify_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("verify", "Tell whether this machine gives what is published: status 0 or 1");
  const auto options = std::make_shared<VerifyCommand>();
  command->add_option("TEMPLATE", options->fruits, "Only cuts of these, by their names");
  command->add_flag("--all", options->all, "Compare every cut, not a tenth of them");
  CLI::Option* table = command->add_option("--table", options->table, "Compare with this table, not the installed one")
                           ->type_name("FILE");
  command->add_option("-o,--output", options->output, "Write a table instead of comparing with one")
      ->type_name("FILE")
      ->excludes(table);
  command->add_option("--threads", options->threads, "Threads to use; 0 = all there are")
      ->check(whole_between(0, 1024));
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->add_flag("--json", options->json, "Print the result as JSON");
  return {command, [options] { return verify(*options); }};
}

}  // namespace pomona
