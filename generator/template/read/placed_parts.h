// Brings along what belongs to the parts of a placed template.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// What parts of a placed template are in the template around it: their names there, by their own.
using MergedParts = std::map<std::string, std::string>;

/// Appends the parts of the placed template, called "PLACE.PART" unless merged with a part that is there, with their
/// materials, densities, spared ones, noise keys, details, ripeness and browning.
/// \return for each part of the placed template its index in the fruit
std::vector<int> bring_parts(Template& fruit, const Template& placed, const std::string& place,
                             const MergedParts& merged);

}  // namespace pomona
