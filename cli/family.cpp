#include "cli/family.h"

#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>

#include "generator/base/error.h"

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
  throw Error(ExitStatus::usage, "--seeds " + text + " are not up to 64 seeds", "write --seeds 1-5, or --seeds 0,2,7");
}

}  // namespace

void add_seeds_option(CLI::App& command, std::string& seeds) {
  command.add_option("--seeds", seeds, "Several variants side by side, at one scale: 1-5, or 0,2,7")
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
    if (output.format != Format::ply && output.format != Format::html && output.format != Format::pomona) continue;
    throw Error(ExitStatus::usage, "--seeds: " + output.file.string() + " holds one fruit alone",
                "write .glb, .usda, .obj, .stl, .pov, .png or .svg");
  }
  if (!options.ripeness_variants.empty()) {
    throw Error(ExitStatus::usage, "--seeds does not go with --ripeness-variants", "leave one of them out");
  }
}

std::vector<Solid> family(const std::vector<std::uint64_t>& seeds, const SharedOptions& options,
                          const std::function<std::vector<Solid>(const SharedOptions&)>& of_one) {
  std::vector<Solid> all;
  for (const std::uint64_t seed : seeds) {
    SharedOptions one = options;
    one.seed = seed;
    std::vector<Solid> solids = of_one(one);
    for (Solid& solid : solids) solid.name += "-seed-" + std::to_string(seed);
    all.insert(all.end(), std::make_move_iterator(solids.begin()), std::make_move_iterator(solids.end()));
  }
  return all;
}

}  // namespace pomona
