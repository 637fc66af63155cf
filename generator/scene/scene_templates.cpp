#include "generator/scene/scene_templates.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>

#include "generator/base/beside.h"
#include "generator/base/error.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

std::filesystem::path template_file(const SceneDescription& scene, const PiecesDescription& pieces,
                                    const ComposeOptions& options) {
  if (const auto beside = found_beside(scene.file, pieces.template_name)) return *beside;
  try {
    if (options.find_template) return options.find_template(pieces.template_name);
  } catch (const Error& error) {
    throw told_where_named(error, pieces.template_place);
  }
  throw Error(ExitStatus::input_missing,
              {{pieces.template_place, "there is no template \"" + pieces.template_name + "\"", {}}});
}

/// Refuses an entry that asks for something that its template does not declare.
void check_fits(const PiecesDescription& pieces, const Template& fruit) {
  const auto refuse = [&](const std::string& why) {
    throw Error(
        ExitStatus::bad_data,
        {{pieces.template_place, "pieces \"" + pieces.name + "\": \"" + pieces.template_name + "\" " + why, {}}});
  };
  if (pieces.folds && !std::holds_alternative<FoldSymmetry>(fruit.symmetry)) refuse("has no folds");
  if (pieces.ripeness && !fruit.ripeness.declared()) refuse("does not say how it ripens");
  if (pieces.browning && !fruit.browning.declared()) refuse("does not say how it turns brown");
}

}  // namespace

std::vector<Template> scene_templates(const SceneDescription& scene, const ComposeOptions& options) {
  std::vector<Template> templates;
  std::vector<std::filesystem::path> files;
  for (const PiecesDescription& pieces : scene.pieces) {
    if (options.ready_template) {
      templates.push_back(*options.ready_template(pieces.template_name).fruit);
      check_fits(pieces, templates.back());
      continue;
    }
    files.push_back(template_file(scene, pieces, options));
    const auto known = std::find(files.begin(), files.end() - 1, files.back()) - files.begin();
    templates.push_back(known + 1 < std::ssize(files) ? templates[static_cast<std::size_t>(known)]
                                                      : read_template(files.back()));
    check_fits(pieces, templates.back());
  }
  return templates;
}

}  // namespace pomona
