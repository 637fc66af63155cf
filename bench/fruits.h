// The fruits and cuts that all benchmarks measure: every template there is, as drawn.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/compose/grow.h"
#include "generator/cut/section/cross_section.h"
#include "generator/knife/knife.h"
#include "generator/template/template.h"

namespace pomona::bench {

struct BenchFruit {
  std::string name;  ///< name of the template
  Template drawn;
  GrownFruit grown;  ///< seed 0
};

/// The fruits with these names, or all in templates/, sorted by name; "organs/grape" is one that others place. \throws
/// Error (input_missing) if there is no such template.
std::vector<std::string> fruit_names(const std::vector<std::string>& wanted = {});

/// The path of the template with this name.
std::filesystem::path template_path(const std::string& name);

/// `detail`: as in SweepOptions.
BenchFruit grow_fruit(const std::string& name, double detail = 1);

/// The detail, from 0.1 to 4, at which the template has about this number of triangles.
double detail_for(const std::string& name, int triangles);

/// The three cuts of the error atlas: half, across, and a slanted plane through the middle.
struct BenchCut {
  std::string name;
  Knife knife;
};
std::vector<BenchCut> standard_cuts(const DiffusionSurfaces& surfaces);

/// The interior vertices, whose colours are diffused.
std::vector<glm::vec3> interior_positions(const CrossSection& section);

}  // namespace pomona::bench
