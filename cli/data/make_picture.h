// One picture of a data set, from its number to its files. Nothing is written here.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/batch/item_work.h"
#include "generator/data/drawn_picture.h"
#include "generator/scene/compose_options.h"
#include "render/gl/scene_picture.h"
#include "render/style/style.h"

namespace pomona {

/// What all pictures share.
struct PictureTools {
  /// The picture of a scene in a style, by OpenGL.
  using Draw = std::function<Image(const Scene& scene, const Style& style, const PictureOptions& options)>;

  const DataPlan& plan;
  std::map<std::string, Style> styles;  ///< by the names in the file
  std::string program;                  ///< "pomona 0.6.0"
  std::string words;                    ///< of the set, for commands: its file and what stands behind
  Draw draw;
};

/// The picture's files; item.json is the last.
/// \param composing how templates are found.
/// \throws Error if things do not come to rest, whatever the attempt.
std::vector<NamedFile> picture_files(const PictureTools& tools, std::int64_t number, const ComposeOptions& composing);

/// item.json of a picture that could not be made.
NamedFile failed_picture(const PictureTools& tools, std::int64_t number, const std::string& error);

}  // namespace pomona
