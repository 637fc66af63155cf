#include "cli/family.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/live_fruit.h"
#include "cli/option_checks.h"
#include "generator/base/error.h"
#include "generator/scene/in_a_row.h"

namespace pomona {

namespace {

constexpr std::size_t most_seeds = 64;

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

[[noreturn]] void fail(const std::string& text) {
  throw Error(ExitStatus::usage, "--seeds " + text + " is no list of seeds",
              "write --seeds 1-5, or --seeds 0,2,7: up to 64 seeds, rising");
}

}  // namespace

void add_seeds_option(CLI::App& command, std::string& seeds) {
  command.add_option("--seeds", seeds, "Several variants side by side, at one scale: 1-5, or 0,2,7")
      ->check(not_empty())
      ->excludes("--seed");
}

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  // A range, or a list.
  const std::size_t dash = text.find('-');
  std::vector<std::uint64_t> seeds;
  if (dash != std::string::npos) {
    const auto first = whole_number(text.substr(0, dash)), last = whole_number(text.substr(dash + 1));
    if (!first || !last || *last < *first || *last - *first >= most_seeds) fail(text);
    for (std::uint64_t seed = *first; seeds.size() <= *last - *first; ++seed) seeds.push_back(seed);
    return seeds;
  }
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const auto seed = whole_number(text.substr(from, comma - from));
    if (!seed || seeds.size() == most_seeds) fail(text);
    seeds.push_back(*seed);
    from = comma + 1;
  }
  return seeds;
}

void check_family(const SharedOptions& options, const std::vector<Output>& outputs) {
  for (const Output& output : outputs) {
    if (output.format != Format::ply && output.format != Format::pomona) continue;
    throw Error(ExitStatus::usage, "--seeds: " + output.file.string() + " holds one fruit alone",
                "write .glb, .usda, .obj, .stl, .pov, .png, .svg or .html");
  }
  if (!options.ripeness_variants.empty() || options.as_drawn) {
    throw Error(ExitStatus::usage, "--seeds does not go with --ripeness-variants and --as-drawn", "leave them out");
  }
}

std::vector<SharedOptions> each_seed(const std::string& seeds, const SharedOptions& options) {
  std::vector<SharedOptions> all;
  for (const std::uint64_t seed : parse_seeds(seeds)) {
    all.push_back(options);
    all.back().seed = seed;
    all.back().seed_given = true;
  }
  return all;
}

std::vector<Solid> named_by_seed(std::vector<Solid> solids, std::uint64_t seed) {
  for (Solid& solid : solids) solid.name += "-seed-" + std::to_string(seed);
  return solids;
}

void add_row(std::vector<Solid> solids, const std::vector<Output>& outputs, Delivery& delivery) {
  Scene row = in_a_row(std::move(solids));
  row.paper = delivery.style().paper;
  for (const Output& output : outputs) {
    if (!is_live(output.format)) delivery.add(output, row);
  }
}

}  // namespace pomona
