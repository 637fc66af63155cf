// The templates that a batch or a data set names: each read once, with its hash.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "generator/batch/batch_file.h"
#include "generator/template/template.h"

namespace pomona {

struct PlannedTemplate {
  std::string name;    ///< without folder and ending
  std::string sha256;  ///< hash of its file and of all files that it names
  Template fruit;
};

/// Finds templates: by paths from the file that asks for them, else as the command line does.
struct TemplateSource {
  std::filesystem::path asking = {};
  std::function<std::filesystem::path(const std::string&)> find;
  std::function<std::vector<std::filesystem::path>()> all;
};

/// The files behind these names, or all those of the program.
/// \throws Error (input_missing) with the place of a name that is no template, (bad_data) for surfaces.
std::vector<std::filesystem::path> template_files(bool all, const std::vector<TemplateWanted>& wanted,
                                                  const TemplateSource& source);

/// Templates by the order in which they are first asked for.
class TemplateShelf {
 public:
  /// The index of the template in the file, which is read unless it has been.
  std::size_t index_of(const std::filesystem::path& file);

  /// All of them, which the shelf then lacks.
  std::vector<PlannedTemplate> taken() { return std::move(templates_); }
  const PlannedTemplate& at(std::size_t index) const { return templates_[index]; }

 private:
  std::vector<std::filesystem::path> files_;
  std::vector<PlannedTemplate> templates_;
};

}  // namespace pomona
