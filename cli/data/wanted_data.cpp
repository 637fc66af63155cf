#include "cli/data/wanted_data.h"

#include "cli/options/file_kind.h"
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "generator/base/version.h"

namespace pomona {

namespace {

/// What is wrong with the name of a style is told where it stands; what is wrong in its file, there.
void check_style(const std::string& style, const SourcePlace& place) {
  try {
    find_style(style);
  } catch (const Error& error) {
    const Diagnostic& what = error.diagnostics().front();
    if (!what.place.file.empty() && error.status() == ExitStatus::bad_data) throw;
    throw Error(error.status() == ExitStatus::usage ? ExitStatus::bad_data : error.status(),
                {{place, what.message, what.hint}});
  }
}

}  // namespace

DataPlan wanted_data(const std::filesystem::path& file) {
  check_kind(file, FileKind::data);
  DataPlan plan = planned(read_data(file), {.find = find_template, .all = all_templates});
  for (std::size_t i = 0; i < plan.data.style_places.size(); ++i)
    check_style(plan.data.styles[i], plan.data.style_places[i]);
  return plan;
}

std::string record_of(const DataPlan& plan) { return data_record(plan, std::string("pomona ") + version); }

}  // namespace pomona
