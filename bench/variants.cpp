// How variants of templates come out: how unlike each other they are, how often folds had to step back towards the
// drawing, and which swept surfaces cross that do not as drawn.
//   variants COUNT TEMPLATE.toml... [amount=A] [folds=N]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/surface/sweep.h"
#include "generator/template/read_template.h"
#include "generator/variation/vary_folds.h"
#include "tests/shapes/crossings.h"

namespace {

using namespace pomona;

using CrossingCounts = std::map<std::pair<int, int>, int>;

struct Settings {
  int count = 0;
  VariationOptions options;
};

/// Root mean square distance of equal vertices, over the size of the fruit.
double distance_between(const DiffusionSurfaces& a, const DiffusionSurfaces& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    const glm::dvec3 difference = glm::dvec3(a.position[v]) - glm::dvec3(b.position[v]);
    sum += glm::dot(difference, difference);
  }
  return std::sqrt(sum / static_cast<double>(a.vertex_count())) / glm::length(bounds_of(a).size());
}

void print_distances(const std::vector<DiffusionSurfaces>& variants) {
  double least = 1e9, sum = 0;
  int pairs = 0;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = distance_between(variants[i], variants[j]);
      least = std::min(least, distance);
      sum += distance;
      ++pairs;
    }
  }
  std::printf("  distance between two: least %.2f %%, mean %.2f %% of the size\n", 100 * least, 100 * sum / pairs);
}

void print_rungs(const Template& fruit, const Settings& settings) {
  std::map<int, int> rungs;
  int unsound = 0;
  for (int seed = 1; seed <= settings.count; ++seed) {
    const int folds = settings.options.folds.value_or(fold_count(fruit));
    const VariantKey key{static_cast<std::uint64_t>(seed), 0};
    for (const FoldReport& fold : vary_folds(fruit, key, settings.options.amount, folds).folds) {
      ++rungs[fold.rung];
      unsound += !fold.sound;
    }
  }
  std::printf("  folds by rung:");
  for (const auto& [rung, number] : rungs) std::printf("  %d: %d", rung, number);
  std::printf("; unsound: %d\n", unsound);
}

void print_crossings(const std::vector<DiffusionSurfaces>& variants, const CrossingCounts& drawn) {
  std::map<std::pair<int, int>, int> variants_with, most;
  for (const DiffusionSurfaces& variant : variants) {
    for (const auto& [pair, number] : crossing_triangles(variant)) {
      ++variants_with[pair];
      most[pair] = std::max(most[pair], number);
    }
  }
  const std::vector<std::string>& names = variants.front().surface_names;
  for (const auto& [pair, number] : variants_with) {
    const auto found = drawn.find(pair);
    std::printf("  %s x %s: in %d of %zu variants, up to %d pairs of triangles (as drawn: %d)\n",
                names[static_cast<std::size_t>(pair.first)].c_str(),
                names[static_cast<std::size_t>(pair.second)].c_str(), number, variants.size(), most[pair],
                found == drawn.end() ? 0 : found->second);
  }
}

void report(const Template& fruit, const Settings& settings) {
  std::printf("%s\n", fruit.name.c_str());
  std::vector<Template> templates;
  const auto start = std::chrono::steady_clock::now();
  for (int seed = 1; seed <= settings.count; ++seed) {
    templates.push_back(vary(fruit, {static_cast<std::uint64_t>(seed), 0}, settings.options));
  }
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
  std::printf("  vary: %.1f ms each\n", passed.count() / settings.count);

  std::vector<DiffusionSurfaces> variants;
  for (const Template& variant : templates) variants.push_back(sweep(variant));
  print_distances(variants);
  if (std::holds_alternative<FoldSymmetry>(fruit.symmetry)) print_rungs(fruit, settings);
  print_crossings(variants, crossing_triangles(sweep(fruit)));
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (i == 1) {
      settings.count = std::atoi(argv[i]);
    } else if (word.rfind("amount=", 0) == 0) {
      settings.options.amount = std::atof(word.c_str() + 7);
    } else if (word.rfind("folds=", 0) == 0) {
      settings.options.folds = std::atoi(word.c_str() + 6);
    } else {
      files.push_back(word);
    }
  }
  if (settings.count < 2 || files.empty()) {
    std::fprintf(stderr, "variants COUNT TEMPLATE.toml... [amount=A] [folds=N]\n");
    return 64;
  }
  for (const std::string& file : files) report(read_template(file), settings);
  return 0;
}
