// A template: the description of a fruit as plain data, as drawn or as varied. read_template.h reads it,
// surface/sweep.h sweeps it, variation/vary.h varies it.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "generator/template/axis_bend.h"
#include "generator/template/browning_sketch.h"
#include "generator/template/detail_sketch.h"
#include "generator/template/grain_sketch.h"
#include "generator/template/individual.h"
#include "generator/template/ink_style.h"
#include "generator/template/law_sketch.h"
#include "generator/template/material_sketch.h"
#include "generator/template/mesh_sketch.h"
#include "generator/template/noise_style.h"
#include "generator/template/place_sketch.h"
#include "generator/template/proportions.h"
#include "generator/template/ripeness_sketch.h"
#include "generator/template/sheet_sketch.h"
#include "generator/template/surface_sketch.h"
#include "generator/template/variation_sketch.h"

namespace pomona {

/// Structures stay much the same after any turn around the axis (paper, section 4.1).
struct CylindricalSymmetry {};

/// N repetitive structures around the axis. Fold k spans [fold_angles[k], fold_angles[k + 1]), the last one
/// up to fold_angles[0] + 2 pi; radians, ascending, from +X towards -Z.
struct FoldSymmetry {
  std::vector<double> fold_angles;
};

/// Nothing repeats: all surfaces are meshes, and all variants are alike.
struct NoSymmetry {};

using Symmetry = std::variant<CylindricalSymmetry, FoldSymmetry, NoSymmetry>;

struct Template {
  std::string name;   ///< as in `pomona list`
  std::string title;  ///< for people: "Bell pepper"
  std::string latin;  ///< Latin name of the species: "Capsicum annuum"; may be empty
  std::string file;   ///< path of its file, for messages
  Symmetry symmetry;
  std::vector<std::string> parts;
  std::vector<SurfaceSketch> surfaces;
  std::vector<SheetSketch> sheets;  ///< after the drawn surfaces
  std::vector<MeshSketch> meshes;   ///< after the sheets
  std::vector<LawSketch> laws;      ///< by which grains and spots may sit
  std::vector<GrainSketch> grains;
  std::vector<PlaceSketch> places;
  AxisBend bend;                          ///< the axis, along which curves are drawn straight
  Proportions proportions;                ///< set in variants: how they differ from the drawing
  VariationSketch variation;              ///< variation besides the horizontal curves
  std::vector<MaterialSketch> materials;  ///< one per part, or none
  NoiseStyle noise;
  std::vector<DetailSketch> details;  ///< at most max_details_of_a_face of each kind of face
  InkStyle ink;
  RipenessSketch ripeness;
  BrowningSketch browning;
  Individual individual;          ///< set in variants
  double density = 1000;          ///< kg per cubic metre; that of water where nothing says otherwise
  std::vector<double> densities;  ///< likewise, one per part; or none: all parts have that of the fruit
  std::vector<int> spared;        ///< parts that knives leave whole in one piece; ascending
  std::vector<int> held;          ///< parts that, cut loose, stay with the piece that they lie against; ascending
};

/// The heights of the lowest and highest point of all vertical curves, metres; 0 and 0 without any.
struct HeightRange {
  double low = 0, high = 0;
};
HeightRange drawn_heights(const Template& fruit);

/// Largest number of folds, drawn or asked for.
constexpr int max_folds = 64;

/// Folds, or 1 where there are none.
int fold_count(const Template& fruit);

/// "seed_coat" as one writes it: "seed coat".
std::string words_of(const std::string& name);

}  // namespace pomona
