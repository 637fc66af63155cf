#include "generator/scene/check_cuts.h"

#include "generator/cut/cut.h"
#include "generator/piece/grow.h"

namespace pomona {

void check_cuts(const SceneDescription& scene, const std::vector<Template>& templates) {
  constexpr double coarse = 0.25;
  for (std::size_t entry = 0; entry < templates.size(); ++entry) {
    const PiecesDescription& pieces = scene.pieces[entry];
    const GrownFruit grown = grow(templates[entry], {}, {.as_drawn = true, .detail = coarse});
    try {
      cut(grown.sheets, pieces.knives);
    } catch (const Error& error) {
      throw at_entry(pieces, error);
    }
  }
}

Error at_entry(const PiecesDescription& pieces, const Error& error) {
  const Diagnostic& what = error.diagnostics().front();
  return {ExitStatus::bad_data, {{pieces.place, "pieces \"" + pieces.name + "\": " + what.message, what.hint}}};
}

}  // namespace pomona
