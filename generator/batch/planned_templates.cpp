#include "generator/batch/planned_templates.h"

#include <algorithm>

#include "generator/base/beside.h"
#include "generator/base/small_ending.h"
#include "generator/batch/template_hash.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

/// The file behind a name; a fault is reported at the name's place.
fs::path template_file(const TemplateWanted& wanted, const TemplateSource& source) {
  try {
    const auto beside = found_beside(source.asking, wanted.name);
    const fs::path file = beside ? *beside : source.find(wanted.name);
    if (small_ending(file) != ".ply") return file;
  } catch (const Error& error) {
    throw told_where_named(error, wanted.place);
  }
  throw Error(ExitStatus::bad_data, {{wanted.place, "\"" + wanted.name + "\" holds surfaces, which have no variants",
                                      "a template takes them as a [[mesh]] (docs/guides/import.md)"}});
}

}  // namespace

std::vector<fs::path> template_files(bool all, const std::vector<TemplateWanted>& wanted,
                                     const TemplateSource& source) {
  if (all) return source.all();
  std::vector<fs::path> files;
  for (const TemplateWanted& one : wanted) files.push_back(template_file(one, source));
  return files;
}

std::size_t TemplateShelf::index_of(const fs::path& file) {
  const auto found = std::find(files_.begin(), files_.end(), file);
  if (found != files_.end()) return static_cast<std::size_t>(found - files_.begin());
  files_.push_back(file);
  templates_.push_back({file.stem().string(), template_hash(file), read_template(file)});
  return templates_.size() - 1;
}

}  // namespace pomona
