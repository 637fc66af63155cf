#include "render/export/piece_words.h"

#include "generator/order/ordered_fruit.h"
#include "generator/piece/piece_facts.h"

namespace pomona {

std::string command_for(const Solid& solid, const ExportOptions& options, const std::string& ending) {
  return command_for(solid.origin, solid.name + ending, options.command_words);
}

bool is_fruit(const Solid& solid) { return solid.origin.number > 0; }

glm::vec3 pivot_of(const Solid& solid) { return is_fruit(solid) ? glm::vec3(facts_of(solid).center) : glm::vec3(0); }

}  // namespace pomona
