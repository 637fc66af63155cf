// A data set ready to be made: its templates read, its files found. Pictures are not stored; each is drawn from its
// number (drawn_picture.h).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "generator/batch/planned_templates.h"
#include "generator/data/data_file.h"
#include "generator/mesh/box.h"
#include "generator/piece/piece_state.h"

namespace pomona {

/// A kind of content whose templates have been found.
struct PlannedKind {
  std::vector<std::size_t> templates;  ///< indices into DataPlan::templates
  std::vector<std::string> words;      ///< how the file calls each
  double chance = 0;                   ///< that a fruit of a picture is of this kind; they add up to 1
};

struct DataPlan {
  DataDescription data;
  std::vector<PlannedTemplate> templates;    ///< each once
  std::vector<Box<double>> extents;          ///< of each template as drawn, metres
  std::vector<PlannedKind> kinds;            ///< as in the file
  std::map<std::string, std::string> files;  ///< SHA-256 of all other files that pictures depend on, by name
  std::vector<std::string> classes;          ///< what detectors tell apart, in the order of their numbers
};

/// \throws Error (input_missing) with the place of a name that is no template, (bad_data) for a template that is wrong.
DataPlan planned(DataDescription data, const TemplateSource& source);

/// The class of a piece: "kiwi", "wedge", or "kiwi wedge".
std::string class_of(DataClasses classes, const std::string& species, std::string_view state);

/// The name of the part of the set that a picture belongs to, whatever their number.
std::string split_of(const DataDescription& data, std::int64_t number);

/// batch.json of the set: what its folder holds, and all that writes of the whole set need.
/// \param program "pomona 0.6.0".
std::string data_record(const DataPlan& plan, const std::string& program);

/// SHA-256 of all that a picture depends on, but its place.
std::string picture_recipe(const DataPlan& plan, const std::string& program, std::int64_t number);

}  // namespace pomona
