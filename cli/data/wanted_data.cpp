#include "cli/data/wanted_data.h"

#include "cli/options/file_kind.h"
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "generator/base/beside.h"
#include "generator/base/file_bytes.h"
#include "generator/base/version.h"
#include "render/image/environment.h"

namespace pomona {

namespace {

/// What is wrong with the name of a style is told where it stands; what is wrong in its file, there.
void check_style(const std::string& style, const SourcePlace& place) {
  try {
    find_style(style_beside(place.file, style));
  } catch (const Error& error) {
    const Diagnostic& what = error.diagnostics().front();
    if (!what.place.file.empty() && error.status() == ExitStatus::bad_data) throw;
    throw Error(error.status() == ExitStatus::usage ? ExitStatus::bad_data : error.status(),
                {{place, what.message, what.hint}});
  }
}

/// What is no environment is told before anything is made.
void check_environments(const DataGround& ground) {
  constexpr std::size_t max_picture = std::size_t{256} << 20;  // bytes
  for (const DataBackground& picture : ground.pictures) {
    if (!picture.is_environment) continue;
    read_environment(file_bytes(picture.file, max_picture), picture.file.string());
  }
}

}  // namespace

DataPlan wanted_data(const std::filesystem::path& file, const BackgroundPaths& behind) {
  check_kind(file, FileKind::data);
  DataPlan plan =
      planned(with_backgrounds(read_data(file), behind), {.asking = file, .find = find_template, .all = all_templates});
  for (std::size_t i = 0; i < plan.data.style_places.size(); ++i)
    check_style(plan.data.styles[i], plan.data.style_places[i]);
  check_environments(plan.data.ground);
  return plan;
}

std::string record_of(const DataPlan& plan) { return data_record(plan, std::string("pomona ") + version); }

}  // namespace pomona
