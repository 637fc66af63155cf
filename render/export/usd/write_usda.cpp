#include "render/export/usd/write_usda.h"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/utf8.h"
#include "render/export/collision/collision_shape.h"
#include "render/export/collision/settled_hulls.h"
#include "render/export/look_palette.h"
#include "render/export/piece_groups.h"
#include "render/export/piece_words.h"
#include "render/export/up_axis.h"
#include "render/export/usd/usda_piece.h"
#include "render/export/weld.h"
#include "render/image/png.h"
#include "render/picture/view_frame.h"

namespace pomona {

using namespace usd;

namespace {

/// The number of meshes styled at once; they are freed when they are text.
constexpr std::size_t meshes_at_once = 64;

glm::dquat unit(const glm::dquat& q) {
  const double length = std::sqrt(glm::dot(q, q));
  return length > 0 ? q / length : glm::dquat(1, 0, 0, 0);
}

/// What things collide with in convex parts, found once for classes of pieces and for where they lie.
struct PieceShapes {
  std::vector<std::vector<ConvexHull>> parts;          ///< per solid, in place of its mesh; none where that serves
  std::vector<std::vector<ConvexHull>> settled;        ///< per instance, where neighbours leave less room
  std::vector<std::vector<std::size_t>> instances_of;  ///< of each solid, those that have such
  std::vector<std::vector<std::size_t>> overlapping;   ///< per instance, those that it must not collide with
};

/// The solids' class prims and their names; none for a solid without triangles.
struct Pieces {
  std::vector<std::string> name;  ///< per solid
  std::string text;
  Looks looks;
  LookPalette palette = {};  ///< of colours in vertices, where looks share a material
  PrimNames names = {};      ///< of all classes
  PieceShapes shapes = {};
  std::vector<std::string> own_name = {};  ///< per instance, of the class with its own shapes; else empty
};

/// Pieces that welds join, and those of an instancer, have the shapes of their solids.
PieceShapes shapes_of(const Scene& scene, const ExportOptions& options) {
  const bool lie_settled = !options.welded && !options.instances && is_settled(scene);
  const bool are_joined = options.welded && !options.instances;
  const auto has_parts = [&](const Solid& solid) { return options.hulls > 1 && is_fruit(solid); };
  const std::size_t solids = scene.solids.size(), instances = scene.instances.size();
  PieceShapes shapes{.parts = std::vector<std::vector<ConvexHull>>(solids),
                     .settled = std::vector<std::vector<ConvexHull>>(instances),
                     .instances_of = std::vector<std::vector<std::size_t>>(solids),
                     .overlapping = std::vector<std::vector<std::size_t>>(instances)};
  parallel_for(solids, options.threads, [&](std::size_t i) {
    if (lie_settled || are_joined || has_parts(scene.solids[i]))
      shapes.parts[i] = collision_parts(scene.solids[i], options.hulls);
  });
  if (lie_settled) shapes.settled = settled_hulls(scene, shapes.parts, options.threads);
  if (are_joined) {
    for (const auto& [first, second] : instances_that_overlap(scene, shapes.parts, options.threads)) {
      shapes.overlapping[first].push_back(second);
      shapes.overlapping[second].push_back(first);
    }
  }
  for (std::size_t i = 0; i < solids; ++i)
    if (!has_parts(scene.solids[i])) shapes.parts[i].clear();
  for (std::size_t i = 0; i < instances; ++i)
    if (!shapes.settled[i].empty())
      shapes.instances_of[static_cast<std::size_t>(scene.instances[i].solid)].push_back(i);
  return shapes;
}

/// What pieces of the scene begin with.
Pieces begun_pieces(const Scene& scene, const ExportOptions& options) {
  Pieces pieces;
  pieces.shapes = shapes_of(scene, options);
  pieces.own_name.resize(scene.instances.size());
  return pieces;
}

/// The class of a solid, and those of its instances that have shapes of their own.
void add_text(Pieces& pieces, std::size_t number, std::span<const StyledLevel> levels, const ExportOptions& options,
              std::span<const TextureChoice> choices = {}) {
  const std::string& name = pieces.name[number];
  const PieceShapes& shapes = pieces.shapes;
  pieces.text += piece_text(name, levels, shapes.parts[number], pieces.looks, options, choices);
  for (const std::size_t instance : shapes.instances_of[number]) {
    pieces.own_name[instance] = pieces.names.name_for(name + "_settled");
    pieces.text +=
        settled_text(pieces.own_name[instance], levels.front(), shapes.settled[instance], pieces.looks, options);
  }
}

/// A level whose looks stand on the palette.
MeshOnPalette on_palette_of(Pieces& pieces, const Solid& solid, const StyledMesh& mesh) {
  return on_palette(mesh, groups_by_material(solid, mesh), pieces.palette);
}

void add_piece(Pieces& pieces, std::size_t number, const Solid& solid, const StyledMesh& mesh,
               std::span<const Solid> coarser, const ExportOptions& options) {
  const std::vector<StyledMesh> styled = styled_meshes(coarser, options);
  std::vector<StyledLevel> levels{{solid, mesh}};
  for (std::size_t level = 0; level < coarser.size(); ++level) levels.push_back({coarser[level], styled[level]});
  if (options.atlas == AtlasOf::none) {
    add_text(pieces, number, levels, options);
    return;
  }
  std::vector<MeshOnPalette> placed;
  for (const StyledLevel& level : levels) placed.push_back(on_palette_of(pieces, level.solid, level.mesh));
  const std::string of = solid.origin.fruit.empty() ? solid.name : solid.origin.fruit;
  std::vector<StyledLevel> joined;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    joined.push_back({.solid = levels[level].solid,
                      .mesh = placed[level].mesh,
                      .in_maps = std::move(placed[level].groups),
                      .material = options.atlas == AtlasOf::file ? "looks" : of});
  }
  add_text(pieces, number, joined, options);
}

Pieces pieces_of(const Scene& scene, const ExportOptions& options, std::span<const std::vector<Solid>> levels) {
  Pieces pieces = begun_pieces(scene, options);
  pieces.name.resize(scene.solids.size());
  const std::span<const Solid> solids = scene.solids;
  for (std::size_t first = 0; first < solids.size(); first += meshes_at_once) {
    const std::size_t count = std::min(meshes_at_once, solids.size() - first);
    const std::vector<StyledMesh> styled = styled_meshes(solids.subspan(first, count), options);
    for (std::size_t i = first; i < first + count; ++i) {
      if (styled[i - first].triangle.empty()) continue;
      pieces.name[i] = pieces.names.name_for(solids[i].name);
      const std::span<const Solid> coarser =
          i < levels.size() ? std::span<const Solid>(levels[i]) : std::span<const Solid>();
      add_piece(pieces, i, solids[i], styled[i - first], coarser, options);
    }
  }
  return pieces;
}

/// Pieces with textures, and the textures as files.
class TexturedPieces {
 public:
  TexturedPieces(const Scene& scene, const std::string& stem, const ExportOptions& options)
      : pieces(begun_pieces(scene, options)), stem_(as_utf8(stem)), options_(options) {}

  void add(const BakedSolid& solid, std::span<const BakedSolid> coarser, std::span<const TextureVariant> variants,
           std::size_t number);

  Pieces pieces;
  std::vector<NamedFile> textures;

 private:
  /// Adds a texture, or that of its page, and returns its file's name. \param what it shows: the piece, and its kind.
  std::string added_texture(const std::string& what, const BakedSolid& baked);

  /// A level with its maps in files.
  StyledLevel level_of(const BakedSolid& baked, const StyledMesh& mesh, const std::string& what);

  std::string stem_;
  const ExportOptions& options_;
  std::map<const TexturePage*, std::string> colors_of_page_;
  std::map<const TexturePage*, MapFiles> maps_of_page_;
};

/// Adds the pictures of maps and returns their files' names; but for colours. \param name what their files begin with.
MapFiles added_maps(const std::string& name, const SurfaceMaps& maps, std::vector<NamedFile>& files) {
  const auto add = [&](const char* kind, const auto& picture, PngValues values) {
    files.push_back({name + "_" + kind + ".png", write_png(picture, PngPacking::fast, values)});
    return files.back().name;
  };
  MapFiles made{.orm = add("orm", maps.orm, PngValues::shares)};
  if (!maps.normal.pixels.empty()) made.normal = add("normal", maps.normal, PngValues::shares);
  if (!maps.coat.opacity.empty()) made.coat = add("coat", maps.coat, PngValues::shares);
  if (!maps.sheen.opacity.empty()) made.sheen = add("sheen", maps.sheen, PngValues::srgb);
  return made;
}

std::string TexturedPieces::added_texture(const std::string& what, const BakedSolid& baked) {
  const auto add = [&](const std::string& shown, const Image& picture) {
    textures.push_back({stem_ + "_" + shown + ".png", write_png(picture, PngPacking::fast)});
    return textures.back().name;
  };
  if (!baked.page) return add(what, baked.texture);
  std::string& known = colors_of_page_[baked.page.get()];
  if (known.empty()) known = add(pieces.names.name_for(baked.page->name), baked.page->texture);
  return known;
}

StyledLevel TexturedPieces::level_of(const BakedSolid& baked, const StyledMesh& mesh, const std::string& what) {
  StyledLevel level{baked.solid, mesh, added_texture(what, baked)};
  const SurfaceMaps& maps = baked.page ? baked.page->maps : baked.maps;
  if (!maps.tell_looks) return level;
  level.in_maps = groups_in_maps(groups_by_material(baked.solid, mesh));
  level.material = baked.page ? baked.page->name : what;
  const std::string begin = level.texture.substr(0, level.texture.rfind('.'));
  if (!baked.page) {
    level.maps = added_maps(begin, maps, textures);
  } else {
    MapFiles& known = maps_of_page_[baked.page.get()];
    if (!known.tell_looks()) known = added_maps(begin, maps, textures);
    level.maps = known;
  }
  level.maps.color = level.texture;
  return level;
}

void TexturedPieces::add(const BakedSolid& solid, std::span<const BakedSolid> coarser,
                         std::span<const TextureVariant> variants, std::size_t number) {
  pieces.name.emplace_back();
  if (solid.solid.mesh.triangle.empty()) return;
  const std::string& name = pieces.name.back() = pieces.names.name_for(solid.solid.name);
  std::vector<StyledMesh> meshes{textured_mesh(solid)};
  for (const BakedSolid& level : coarser) meshes.push_back(textured_mesh(level));
  std::vector<StyledLevel> levels{level_of(solid, meshes[0], name)};
  for (std::size_t k = 0; k < coarser.size(); ++k)
    levels.push_back(level_of(coarser[k], meshes[k + 1], name + "_LOD" + std::to_string(k + 1)));

  std::vector<TextureChoice> choices;
  PrimNames of_variants;
  if (!variants.empty()) choices.push_back({of_variants.name_for("as_is"), levels[0].texture});
  for (const TextureVariant& variant : variants) {
    const BakedSolid& other = variant.solids.at(number);
    if (other.uv != solid.uv) throw Error(ExitStatus::bug, "a variant has an atlas of its own");
    const std::string called = of_variants.name_for(variant.name);
    choices.push_back({called, added_texture(name + "_" + called, other)});
  }
  add_text(pieces, number, levels, options_, choices);
}

std::string indented(int indent) { return std::string(static_cast<std::size_t>(4 * indent), ' '); }

glm::dvec3 place_of(const Instance& instance, const Scene& scene, UpAxis up) {
  const glm::dvec3 pivot(pivot_of(scene.solids[static_cast<std::size_t>(instance.solid)]));
  return place_with_up(up, unit(instance.pose.rotation) * pivot + instance.pose.translation);
}

glm::dquat rotation_of(const Instance& instance, UpAxis up) {
  return rotation_with_up(up, unit(instance.pose.rotation));
}

/// A prim for each instance, at its place, in groups within groups, as in an outliner.
class InstancePrims {
 public:
  InstancePrims(const Scene& scene, const Pieces& pieces, UpAxis up) : scene_(scene), pieces_(pieces), up_(up) {
    for (const Instance& instance : scene.instances) {
      const auto solid = static_cast<std::size_t>(instance.solid);
      if (pieces.name[solid].empty()) continue;
      shown_.push_back(&instance);
      paths_.push_back({scene.solids[solid].origin.entry, scene.solids[solid].origin.variant});
    }
  }

  std::string text(PrimNames& names) { return group_text(grouped(paths_), "/Scene", 1, names); }

  /// A joint for each weld of the pieces, after text().
  std::string welds_text(PrimNames& names) const;

 private:
  std::string group_text(const PieceGroup& group, const std::string& within, int indent, PrimNames& names);
  std::string instance_text(const Instance& instance, const std::string& within, int indent, PrimNames& names);

  /// Paths of those that the instance must not collide with and that are text: USD takes a pair from one of both.
  std::string filtered_text(std::size_t instance) const;

  const Scene& scene_;
  const Pieces& pieces_;
  UpAxis up_;
  std::vector<const Instance*> shown_;
  std::vector<PiecePath> paths_;
  std::map<int, std::size_t> of_solid_;         ///< the last instance of each
  std::map<std::size_t, std::string> path_of_;  ///< where an instance's prim is, once it is text
};

std::string InstancePrims::instance_text(const Instance& instance, const std::string& within, int indent,
                                         PrimNames& names) {
  const std::string in = indented(indent), name = names.name_for(instance.name);
  std::string text = in + "def Xform \"" + name + "\" (\n";
  text += in + "    displayName = " + quoted(instance.name) + "\n";
  text += in + "    instanceable = true\n";
  const auto number = static_cast<std::size_t>(&instance - scene_.instances.data());
  const std::string& own = pieces_.own_name[number];
  const std::string filtered = filtered_text(number);
  of_solid_[instance.solid] = number;
  path_of_[number] = within + "/" + name;
  if (!filtered.empty()) text += in + "    prepend apiSchemas = [\"PhysicsFilteredPairsAPI\"]\n";
  // What it inherits is stronger than what it refers to; readers that know references alone take the piece's own shape.
  if (!own.empty()) text += in + "    prepend inherits = </Pieces/" + own + ">\n";
  text += in + "    prepend references = </Pieces/" + pieces_.name[static_cast<std::size_t>(instance.solid)] + ">\n" +
          in + ")\n" + in + "{\n";
  text += in + "    double3 xformOp:translate = " + exact_tuple(place_of(instance, scene_, up_)) + "\n";
  text += in + "    quatd xformOp:orient = " + exact_tuple(rotation_of(instance, up_)) + "\n";
  text += in + "    uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]\n";
  if (!filtered.empty()) text += in + "    rel physics:filteredPairs = [" + filtered + "]\n";
  return text + in + "}\n";
}

std::string InstancePrims::filtered_text(std::size_t instance) const {
  std::string text;
  for (const std::size_t other : pieces_.shapes.overlapping[instance]) {
    const auto path = path_of_.find(other);
    if (path != path_of_.end()) text += (text.empty() ? "<" : ", <") + path->second + ">";
  }
  return text;
}

std::string InstancePrims::group_text(const PieceGroup& group, const std::string& within, int indent,
                                      PrimNames& names) {
  std::string text;
  for (const PieceGroup::Member& member : group.members) {
    if (!member.group) {
      text += instance_text(*shown_[member.item], within, indent, names);
      continue;
    }
    const std::string in = indented(indent), name = names.name_for(member.group->name);
    text += in + "def Xform \"" + name + "\" (\n" + in + "    kind = \"group\"\n" + in +
            "    displayName = " + quoted(member.group->name) + "\n" + in + ")\n" + in + "{\n";
    PrimNames inside;
    text += group_text(*member.group, within + "/" + name, indent + 1, inside) + in + "}\n";
  }
  return text;
}

/// The joint's frame is that of the second piece.
std::string InstancePrims::welds_text(PrimNames& names) const {
  std::string text;
  for (const Weld& weld : welds_of(scene_.solids)) {
    const auto first = of_solid_.find(weld.contact.first), second = of_solid_.find(weld.contact.second);
    if (first == of_solid_.end() || second == of_solid_.end()) continue;
    const Instance &one = scene_.instances[first->second], &other = scene_.instances[second->second];
    const glm::dquat back = glm::conjugate(rotation_of(one, up_));
    const glm::dvec3 away = back * (place_of(other, scene_, up_) - place_of(one, scene_, up_));
    text += "    def PhysicsFixedJoint \"" + names.name_for(weld_name(weld.contact)) + "\"\n    {\n";
    text += "        rel physics:body0 = <" + path_of_.at(first->second) + ">\n";
    text += "        rel physics:body1 = <" + path_of_.at(second->second) + ">\n";
    text += "        point3f physics:localPos0 = " + exact_tuple(away) + "\n";
    text += "        quatf physics:localRot0 = " + exact_tuple(back * rotation_of(other, up_)) + "\n";
    text += "        point3f physics:localPos1 = (0, 0, 0)\n        quatf physics:localRot1 = (1, 0, 0, 0)\n";
    text += "        float physics:breakForce = " + exact(weld.strength) + "\n";
    text += "        custom double squareMetres = " + exact(weld.contact.area) + "\n    }\n";
  }
  return text;
}

/// All of them as one PointInstancer, with a prototype for each solid.
std::string point_instancer_text(const Scene& scene, const Pieces& pieces, UpAxis up, PrimNames& names) {
  std::vector<std::int32_t> proto(scene.solids.size(), -1), index;
  std::string prototypes, targets, positions, orientations;
  std::int32_t count = 0;
  for (const Instance& instance : scene.instances) {
    const auto solid = static_cast<std::size_t>(instance.solid);
    const std::string& piece = pieces.name[solid];
    if (piece.empty()) continue;
    if (proto[solid] < 0) {
      proto[solid] = count++;
      prototypes += "            def Xform \"" + piece + "\" (prepend references = </Pieces/" + piece +
                    ">)\n            {\n            }\n";
      targets += std::string(targets.empty() ? "" : ", ") + "</Scene/pieces/Prototypes/" + piece + ">";
    }
    const char* comma = index.empty() ? "" : ", ";
    index.push_back(proto[solid]);
    positions += comma + tuple(place_of(instance, scene, up), 1e-7);
    const glm::dquat q = rotation_of(instance, up);
    orientations += comma + exact_tuple(glm::dquat(std::round(q.w * 1e7) / 1e7, std::round(q.x * 1e7) / 1e7,
                                                   std::round(q.y * 1e7) / 1e7, std::round(q.z * 1e7) / 1e7));
  }
  std::string text = "    def PointInstancer \"" + names.name_for("pieces") + "\"\n    {\n";
  text += "        rel prototypes = [" + targets + "]\n        int[] protoIndices = " + list(index) + "\n";
  text += "        point3f[] positions = [" + positions + "]\n";
  // Orientations of half precision are for programs before USD 24.08; the others take precedence.
  text += "        quath[] orientations = [" + orientations + "]\n";
  text += "        quatf[] orientationsf = [" + orientations + "]\n\n";
  return text + "        def Scope \"Prototypes\"\n        {\n" + prototypes + "        }\n    }\n";
}

/// A lens on a film 24 mm high; tenths of a scene unit are what USD measures both in.
std::string camera_text(const View& view, UpAxis up, const std::string& name) {
  const ViewFrame frame = view_frame(view);
  const double half = view.vertical_field / 2, film = 24;
  const double focal = film / 2 * reproducible::cos(half) / reproducible::sin(half);
  const glm::dquat turned = rotation_with_up(up, unit(glm::quat_cast(glm::dmat3(frame.right, frame.up, frame.back))));
  std::string text = "    def Camera \"" + name + "\"\n    {\n";
  text += "        float focalLength = " + exact(focal) + "\n        float verticalAperture = 24\n";
  text += "        float horizontalAperture = 32\n        float2 clippingRange = (" + exact(frame.distance / 100) +
          ", " + exact(frame.distance * 100) + ")\n";
  text += "        float focusDistance = " + exact(frame.distance) + "\n";
  text += "        double3 xformOp:translate = " + exact_tuple(place_with_up(up, view.eye)) + "\n";
  text += "        quatd xformOp:orient = " + exact_tuple(turned) + "\n";
  return text + "        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]\n    }\n";
}

/// The active camera: for Omniverse, and by a standard prim for renderers.
std::string head_text(const std::string& camera, const ExportOptions& options) {
  std::string text = "#usda 1.0\n(\n    customLayerData = {\n        dictionary cameraSettings = {\n";
  text += "            string boundCamera = " + quoted(camera) + "\n        }\n    }\n";
  text += "    defaultPrim = \"Scene\"\n    doc = " + quoted("Made by Pomona. " + options.provenance);
  return text + "\n    kilogramsPerUnit = 1\n    metersPerUnit = 1\n    upAxis = " +
         (options.up == UpAxis::z ? "\"Z\"" : "\"Y\"") + "\n)\n\n";
}

std::string render_text(const std::string& camera) {
  return "def Scope \"Render\"\n{\n    def RenderSettings \"settings\"\n    {\n        rel camera = <" + camera +
         ">\n    }\n}\n\n";
}

/// The whole file. All that is drawn is below one prim; classes, which are not, lie beside it.
std::string file_text(const Scene& scene, const Pieces& pieces, const ExportOptions& options) {
  PrimNames names;
  names.name_for("Render");
  InstancePrims prims(scene, pieces, options.up);
  std::string shown = options.instances ? point_instancer_text(scene, pieces, options.up, names) : prims.text(names);
  if (options.welded && !options.instances) shown += prims.welds_text(names);
  const std::string view = names.name_for("view"), camera = "/Scene/" + view;
  std::string text = head_text(camera, options) + "def Xform \"Scene\" (\n    kind = \"assembly\"\n)\n{\n";
  text += shown + camera_text(scene.view, options.up, view) + "\n" + render_text(camera) + "}\n\n";
  text += "class Scope \"Pieces\"\n{\n" + pieces.text + "}\n\n";
  return text + "class Scope \"Looks\"\n{\n" + pieces.looks.text() + "}\n";
}

}  // namespace

std::string write_usda(const Scene& scene, const ExportOptions& options, std::span<const std::vector<Solid>> levels) {
  ExportOptions without = options;
  without.atlas = AtlasOf::none;
  return file_text(scene, pieces_of(scene, without, levels), without);
}

UsdaFiles write_usda(const Scene& scene, const std::string& stem, const ExportOptions& options,
                     std::span<const std::vector<Solid>> levels) {
  UsdaFiles made;
  Pieces pieces = pieces_of(scene, options, levels);
  if (options.atlas != AtlasOf::none)
    pieces.looks.finish(added_maps(as_utf8(stem) + "_looks", pieces.palette.maps(), made.textures));
  made.text = file_text(scene, pieces, options);
  return made;
}

UsdaFiles write_usda(const Scene& scene, std::span<const BakedSolid> baked, const std::string& stem,
                     const ExportOptions& options, std::span<const std::vector<BakedSolid>> levels,
                     std::span<const TextureVariant> variants) {
  TexturedPieces made(scene, stem, options);
  for (std::size_t i = 0; i < baked.size(); ++i) {
    const std::span<const BakedSolid> coarser =
        i < levels.size() ? std::span<const BakedSolid>(levels[i]) : std::span<const BakedSolid>();
    made.add(baked[i], coarser, variants, i);
  }
  return {file_text(scene, made.pieces, options), std::move(made.textures)};
}

}  // namespace pomona
