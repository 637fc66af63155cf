// A user's order as one value: which fruit grows, how it is cut and coloured, and which files are written. The command
// line, batch files and the library fill it; option_table.h says what each member is called there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/base/random.h"
#include "generator/compose/grow.h"
#include "generator/diffusion/quality.h"
#include "generator/knife/knife.h"
#include "generator/order/export_choices.h"
#include "generator/order/format.h"

namespace pomona {

/// Which individual grows, and how.
struct FruitOrder {
  std::optional<std::uint64_t> seed = {};   ///< none: 0, the drawing; for a scene, its file's
  std::optional<std::uint64_t> index = {};  ///< index among the seed's variants; with it seed 0 is a variant, too
  std::vector<std::uint64_t> seeds = {};    ///< several individuals side by side, in place of `seed`
  GrowOptions growing = {};                 ///< its threads are not read: Order::threads counts
};

/// The triangulation of cut faces; scenes use `coarse`.
enum class FaceQuality { fine, coarse };

/// How the fruit is cut.
struct CutOrder {
  std::vector<Knife> knives = {};         ///< one after another; none leave the fruit whole
  FaceQuality faces = FaceQuality::fine;  ///< triangulation of pieces and sections
  bool section = false;                   ///< the cut faces in place of the pieces
  double explode = 1;                     ///< times as far from the middle of all pieces, 1 to 10
  bool crumbs = false;                    ///< bits below a millionth of the fruit are kept as pieces
  int piece = 0;                          ///< this one alone, numbered from 1 in the order of cutting; 0 = all
  std::string piece_list = {};            ///< file for the facts of each piece; empty = none
};

/// Which solver diffuses colour over cut faces. `automatic` is `gl` on a graphics card, else `cpu`.
enum class DiffuserKind { cpu, gl, harmonic, walk, automatic };

/// How cut faces, pictures and textures get their colours.
struct ColorOrder {
  std::optional<DiffuserKind> diffuser = {};  ///< none: cpu; for the grids of pages and assets harmonic
  Quality quality = Quality::final;           ///< the error of the diffusion, nothing else
  std::string style = {};                     ///< name or path; none: see drawn_style() and baked_style()
  std::string style_word = {};                ///< `style` in commands that make a piece again, where that differs
};

/// A length as it was typed, with its unit: commands that make a piece again repeat the words.
struct TypedLength {
  std::string text = {};  ///< "0.2mm"; empty: none
  double metres = 0;
};

/// Content of mesh files besides triangles with colours.
struct MeshOrder {
  int texture = 0;                             ///< texels along a texture's edge; 0 = colours on vertices
  TypedLength texel = {};                      ///< size of a texel, instead of `texture`
  Maps maps = Maps::all;                       ///< maps of textures
  std::optional<AtlasOf> atlas = {};           ///< none: see atlas_of()
  std::string maps_dir = {};                   ///< folder for the textures as pictures, too; empty = none
  int lod = 0;                                 ///< further levels of detail, 0 to 6
  Engine engine = Engine::any;                 ///< for .glb only
  Compression compress = Compression::none;    ///< .glb: how its arrays are coded
  UpAxis up = UpAxis::y;                       ///< .usda: the axis that points up
  int hulls = 1;                               ///< convex parts, at most, that a piece collides with, 1 to 64
  bool welded = false;                         ///< .xml, .usda of a cut: the pieces lie as they grew, joined
  bool instances = false;                      ///< pieces that repeat are one node, or prim, with many places
  bool feature_ids = false;                    ///< .glb: parts as EXT_mesh_features, too
  std::vector<double> ripeness_variants = {};  ///< .glb, .usda with textures: these ripenesses, too
  bool cuttable = false;                       ///< .glb of a whole fruit: carries its asset, too
  bool sheets = false;                         ///< .ply of a whole fruit: everything that the diffuser sees
  bool surfaces = false;                       ///< all surfaces in place of the solid, seen through each other
};

/// The ordered size of a picture: in pixels, or on paper.
struct PictureExtent {
  std::string text = {};  ///< "800x600", "120x90mm"
  double width = 0, height = 0;
  double inches_a_unit = 0;  ///< inches per unit of a size on paper; 0: pixels
};

/// The viewpoint of a picture.
struct Viewpoint {
  std::string text = {};          ///< "front", "30,20"
  glm::dvec3 direction{0, 0, 1};  ///< from the fruit to the eye, of any length
};

/// Options of pictures.
struct PictureOrder {
  std::optional<PictureExtent> size = {};  ///< none: that of the command or the scene
  double dpi = 0;                          ///< pixels per inch on paper; 0 = not said
  std::optional<Viewpoint> view = {};      ///< none: that of the scene
  std::string aov = {};                    ///< folder for the ground truth of the picture; empty = none
  TruthFormat aov_format = TruthFormat::png;
};

/// All of it.
struct Order {
  FruitOrder fruit = {};
  CutOrder cut = {};
  ColorOrder color = {};
  MeshOrder mesh = {};
  PictureOrder picture = {};
  std::vector<Output> outputs = {};  ///< files to write
  Threads threads = {};              ///< no byte of a result depends on them
};

/// The key of the fruit's variant: its seed, and its index among the seed's variants.
VariantKey key_of(const FruitOrder& fruit);

/// How the fruit grows: as `fruit.growing` says, and as drawn at seed 0 without an index.
GrowOptions growing_of(const Order& order);

/// The same order without the outputs of these formats.
Order without(Order order, const std::vector<Format>& formats);

/// Whether colours are baked into textures.
bool wants_textures(const MeshOrder& mesh);

/// The name or path of the style of pictures, pages and vertices, and that of textures: what the order says, else "ink"
/// for what is drawn and "photo" for what others light.
std::string drawn_style(const ColorOrder& color);
std::string baked_style(const ColorOrder& color);

/// What shares one material: as ordered, else in engines each piece, because there a material is a draw call.
AtlasOf atlas_of(const MeshOrder& mesh);

struct PictureSize {
  int width = 0, height = 0;  ///< pixels
};

/// The ordered size, if any.
/// \throws Error (usage) for a size on paper without --dpi, and for a side that is not a whole number of 16 to 16384
/// pixels.
std::optional<PictureSize> picture_size(const PictureOrder& picture);

}  // namespace pomona
