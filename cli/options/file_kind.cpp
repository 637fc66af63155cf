#include "cli/options/file_kind.h"

#include <string>

#include "generator/base/error.h"
#include "generator/base/small_ending.h"
#include "generator/batch/batch_file.h"
#include "generator/data/data_file.h"
#include "generator/scene/scene_file.h"
#include "generator/text/toml_text.h"
#include "render/style/style_file.h"

namespace pomona {

FileKind kind_of(const std::filesystem::path& file) {
  if (is_batch_file(file)) return FileKind::batch;
  if (is_data_file(file)) return FileKind::data;
  if (is_scene_file(file)) return FileKind::scene;
  if (is_style_file(file)) return FileKind::style;
  return has_toml_heading(file, {"[symmetry]", "[[surface]]", "[surface.", "[[mesh]]"}) ? FileKind::fruit
                                                                                        : FileKind::other;
}

KindWords words_of(FileKind kind) {
  switch (kind) {
    case FileKind::fruit:
      return {"is a template", "pomona grow and pomona cut take templates"};
    case FileKind::scene:
      return {"is a scene", "pomona scene takes scenes"};
    case FileKind::batch:
      return {"is a batch", "pomona batch takes batches"};
    case FileKind::data:
      return {"is a data set", "pomona data takes data sets"};
    case FileKind::style:
      return {"is a style", "--style takes styles"};
    case FileKind::other:
      break;
  }
  return {"is none of the program's kinds of files", "`pomona check` tells what is wrong with it"};
}

void check_kind(const std::filesystem::path& file, FileKind wanted) {
  const std::string name = file.string();
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    throw Error(ExitStatus::bad_data, {{{name, 1, 1, {}}, what, hint}});
  };
  const bool is_surfaces = small_ending(file) == ".ply";
  if (small_ending(file) != ".toml" && !(is_surfaces && wanted == FileKind::fruit))
    refuse("has no ending of a file that is read here",
           wanted == FileKind::fruit ? "templates are .toml, surfaces .ply" : "name it FILE.toml");
  const FileKind found = kind_of(file);
  if (found == wanted || found == FileKind::other) return;
  refuse(words_of(found).what, words_of(found).taken_by);
}

}  // namespace pomona
