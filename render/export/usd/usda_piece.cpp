#include "render/export/usd/usda_piece.h"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/mesh/box.h"
#include "generator/mesh/principal_axes.h"
#include "generator/piece/piece_facts.h"
#include "render/export/piece_words.h"

namespace pomona::usd {

namespace {

constexpr double of_points = 1e-7;  ///< metres; equal positions stay equal, so meshes stay closed
constexpr double of_normals = 1e-3, of_colors = 1e-4, of_places = 1e-6;

/// Faces with a common property, as a subset of a mesh.
struct Subset {
  std::string family, name, metadata, binding;
  std::vector<std::int32_t> faces;
};

void append_subset(std::string& text, int indent, const Subset& subset) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("def GeomSubset " + quoted(subset.name) + (subset.metadata.empty() ? "" : " " + subset.metadata));
  line("{");
  line("    uniform token elementType = \"face\"");
  line("    uniform token familyName = " + quoted(subset.family));
  line("    int[] indices = " + list(subset.faces));
  if (!subset.binding.empty()) line(subset.binding);
  line("}");
}

/// The name of the piece's material for a look; for a level of detail with its own texture it names both.
std::string material_name(const std::string& look, const StyledLevel& level, std::size_t number) {
  return level.texture.empty() || number == 0 ? look : look + "_LOD" + std::to_string(number);
}

/// The name of a material where maps tell looks.
std::string name_in_maps(const StyledLevel& level, const MaterialGroup& group, Looks& looks) {
  std::string name = level.material;
  if (!level.solid.closed) name += " (open)";
  return looks.name_for(name, group, level.solid.opacity, level.maps);
}

/// A subset for each material, bound to it beside the mesh.
std::vector<Subset> subsets_by_material(const StyledLevel& level, std::size_t number, Looks& looks) {
  std::vector<Subset> subsets;
  const bool in_maps = !level.in_maps.empty();
  const std::vector<MaterialGroup> groups =
      in_maps ? level.in_maps : groups_by_material(level.solid, level.mesh, LightInside::told);
  for (const MaterialGroup& group : groups) {
    const std::string name =
        in_maps ? name_in_maps(level, group, looks) : material_name(looks.name_for(level.solid, group), level, number);
    Subset subset{"materialBind", "look_" + name, "(\n    prepend apiSchemas = [\"MaterialBindingAPI\"]\n)", {}, {}};
    subset.binding = "    rel material:binding = <../../Looks/" + name + ">";
    subset.faces = group.face;
    subsets.push_back(std::move(subset));
  }
  return subsets;
}

/// A labelled subset for each part; a face has the part of its first corner.
std::vector<Subset> subsets_by_part(const StyledLevel& level) {
  std::map<std::int32_t, std::vector<std::int32_t>> faces;
  for (std::size_t t = 0; t < level.mesh.triangle.size(); ++t)
    faces[level.mesh.part[level.mesh.triangle[t].x]].push_back(static_cast<std::int32_t>(t));
  PrimNames names;
  std::vector<Subset> subsets;
  for (auto& [part, of_part] : faces) {
    const auto number = static_cast<std::size_t>(part);
    if (number >= level.solid.look->part_names.size()) continue;
    const std::string& called = level.solid.look->part_names[number];
    Subset subset{"part", names.name_for("part_" + called), {}, {}, std::move(of_part)};
    subset.metadata = "(\n    prepend apiSchemas = [\"SemanticsLabelsAPI:part\"]\n)";
    subset.binding = "    token[] semantics:labels:part = [" + quoted(called) + "]";
    subsets.push_back(std::move(subset));
  }
  return subsets;
}

/// The look that a level rubs by, where its maps do not say: that of the most triangles.
std::string physical_look(const StyledLevel& level, Looks& looks) {
  const std::vector<MaterialGroup> groups = groups_by_material(level.solid, level.mesh, LightInside::told);
  return looks.name_for(level.solid, *std::max_element(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
                          return a.face.size() < b.face.size();
                        }));
}

/// The name of the material that has the most triangles.
std::string largest_look(const StyledLevel& level, const std::vector<Subset>& by_look, Looks& looks) {
  if (!level.in_maps.empty()) return physical_look(level, looks);
  const auto most = std::max_element(by_look.begin(), by_look.end(),
                                     [](const Subset& a, const Subset& b) { return a.faces.size() < b.faces.size(); });
  return most->name.substr(std::string("look_").size());
}

void append_arrays(std::string& text, int indent, const StyledMesh& mesh, const glm::vec3& pivot) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  std::vector<glm::vec3> points = mesh.position;
  Box<float> box;
  for (glm::vec3& p : points) {
    p -= pivot;
    box.add(p);
  }
  std::vector<std::int32_t> counts(mesh.triangle.size(), 3), corners;
  for (const glm::uvec3& t : mesh.triangle)
    for (int k = 0; k < 3; ++k) corners.push_back(static_cast<std::int32_t>(t[k]));
  line("float3[] extent = [" + tuple(glm::dvec3(box.low), of_points) + ", " + tuple(glm::dvec3(box.high), of_points) +
       "]");
  line("int[] faceVertexCounts = " + list(counts));
  line("int[] faceVertexIndices = " + list(corners));
  line("point3f[] points = " + list(points, of_points));
  line("normal3f[] normals = " + list(mesh.normal, of_normals) + " (interpolation = \"vertex\")");
  if (mesh.uv.empty())
    line("color3f[] primvars:displayColor = " + list(mesh.color, of_colors) + " (interpolation = \"vertex\")");
  if (!mesh.uv.empty() || !mesh.look_place.empty()) {
    // Our rows of texels count from the top, USD's from the bottom.
    std::vector<glm::vec2> places = mesh.uv.empty() ? mesh.look_place : mesh.uv;
    for (glm::vec2& place : places) place.y = 1 - place.y;
    line("texCoord2f[] primvars:st = " + list(places, of_places) + " (interpolation = \"vertex\")");
  }
  line("int[] primvars:part = " + list(mesh.part) + " (interpolation = \"vertex\")");
}

/// How a simulator makes the shape of a mesh that things collide with; empty where hulls of their own do.
enum class Approximation { separate_hulls, convex_hull, triangles };

void append_mesh(std::string& text, int indent, const StyledLevel& level, const glm::vec3& pivot,
                 const std::vector<Subset>& by_look, Approximation approximation, Looks& looks) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  const bool collides = approximation != Approximation::separate_hulls;
  line("def Mesh \"mesh\" (");
  line(std::string("    prepend apiSchemas = [\"MaterialBindingAPI\"") +
       (collides ? ", \"PhysicsCollisionAPI\", \"PhysicsMeshCollisionAPI\"]" : "]"));
  line(")");
  line("{");
  append_arrays(text, indent + 1, level.mesh, pivot);
  line("    uniform token subdivisionScheme = \"none\"");
  if (collides) {
    const bool is_hull = approximation == Approximation::convex_hull;
    line(std::string("    uniform token physics:approximation = ") + (is_hull ? "\"convexHull\"" : "\"none\""));
    // Subsets have looks of their own; what they lie on has that of most.
    if (by_look.size() > 1 || !level.in_maps.empty())
      line("    rel material:binding:physics = <../Looks/" + largest_look(level, by_look, looks) + ">");
  }
  if (!level.solid.closed) line("    uniform bool doubleSided = 1");
  if (by_look.size() == 1) {
    std::string binding = by_look[0].binding;
    line(binding.replace(binding.find("../../"), 6, "../"));
  } else {
    line("    uniform token subsetFamily:materialBind:familyType = \"partition\"");
    for (const Subset& subset : by_look) append_subset(text, indent + 1, subset);
  }
  for (const Subset& subset : subsets_by_part(level)) append_subset(text, indent + 1, subset);
  line("}");
}

/// The data of glTF's `extras`.
void append_custom_data(std::string& text, const Solid& solid, const ExportOptions& options) {
  const PieceOrigin& origin = solid.origin;
  append_line(text, 2, "customData = {");
  std::string parts;
  for (const std::string& part : solid.look->part_names) parts += (parts.empty() ? "" : ", ") + quoted(part);
  append_line(text, 3, "string[] parts = [" + parts + "]");
  append_line(text, 3, "double volume = " + exact(facts_of(solid).volume));
  if (origin.number > 0) {
    append_line(text, 3, "string template = " + quoted(origin.source));
    append_line(text, 3, "uint64 seed = " + std::to_string(origin.key.seed));
    append_line(text, 3, "uint64 index = " + std::to_string(origin.key.index));
    append_line(text, 3, "string knife = " + quoted(knives_text(origin)));
    append_line(text, 3, "int piece = " + std::to_string(origin.number));
    const std::string command = command_for(solid, options, ".usda");
    if (!command.empty()) append_line(text, 3, "string command = " + quoted(command));
  }
  append_line(text, 2, "}");
}

/// The materials of the piece are inside it, because references do not include anything outside. Returns those of the
/// solid itself.
/// \param has_choices the variants name the textures.
std::vector<std::string> append_looks(std::string& text, std::span<const StyledLevel> levels, Looks& looks,
                                      bool has_choices) {
  std::map<std::string, bool> said;
  std::vector<std::string> own;
  append_line(text, 2, "def Scope \"Looks\"");
  append_line(text, 2, "{");
  for (std::size_t number = 0; number < levels.size(); ++number) {
    const StyledLevel& level = levels[number];
    const auto append_reference = [&](const std::string& name, const std::string& look) {
      append_line(text, 3, "def Material \"" + name + "\" (prepend references = </Looks/" + look + ">)");
      append_line(text, 3, "{");
      append_line(text, 3, "}");
    };
    for (const MaterialGroup& group : level.in_maps) {
      const std::string name = name_in_maps(level, group, looks);
      if (std::exchange(said[name], true)) continue;
      if (number == 0) own.push_back(name);
      append_reference(name, name);
    }
    if (!level.in_maps.empty()) {
      const std::string physical = physical_look(level, looks);
      if (!std::exchange(said[physical], true)) append_reference(physical, physical);
      continue;
    }
    for (const MaterialGroup& group : groups_by_material(level.solid, level.mesh, LightInside::told)) {
      const std::string look = looks.name_for(level.solid, group), name = material_name(look, level, number);
      if (std::exchange(said[name], true)) continue;
      if (number == 0) own.push_back(name);
      if (level.texture.empty())
        append_reference(name, look);
      else
        append_textured_material(text, 3, name, look, has_choices ? "" : level.texture);
    }
  }
  append_line(text, 2, "}");
  return own;
}

/// The variant sets, with the first variant of each selected.
void append_variant_sets(std::string& text, bool has_levels, std::span<const TextureChoice> choices) {
  if (!has_levels && choices.empty()) return;
  const auto line = [&](const std::string& words) { append_line(text, 2, words); };
  line("variants = {");
  if (has_levels) line("    string LOD = \"LOD0\"");
  if (!choices.empty()) line("    string ripeness = " + quoted(choices.front().name));
  line("}");
  const std::string both = "[\"LOD\", \"ripeness\"]";
  line("prepend variantSets = " + (choices.empty() ? "\"LOD\"" : has_levels ? both : "\"ripeness\""));
}

/// A convex part, which nobody draws.
void append_hull(std::string& text, const std::string& name, const ConvexHull& hull, const glm::vec3& pivot,
                 const std::string& look) {
  const auto line = [&](const std::string& words) { append_line(text, 2, words); };
  std::vector<glm::vec3> points, normals;
  std::vector<std::int32_t> corners;
  Box<float> box;
  for (const glm::vec3& p : hull.position) points.push_back(p - pivot), box.add(p - pivot);
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3 a(hull.position[t.x]), b(hull.position[t.y]), c(hull.position[t.z]);
    normals.emplace_back(glm::normalize(glm::cross(b - a, c - a)));
    for (int k = 0; k < 3; ++k) corners.push_back(static_cast<std::int32_t>(t[k]));
  }
  line("def Mesh " + quoted(name) + " (");
  line("    prepend apiSchemas = [\"MaterialBindingAPI\", \"PhysicsCollisionAPI\", \"PhysicsMeshCollisionAPI\"]");
  line(")");
  line("{");
  line("    float3[] extent = [" + tuple(glm::dvec3(box.low), of_points) + ", " +
       tuple(glm::dvec3(box.high), of_points) + "]");
  line("    int[] faceVertexCounts = " + list(std::vector<std::int32_t>(hull.triangle.size(), 3)));
  line("    int[] faceVertexIndices = " + list(corners));
  line("    point3f[] points = " + list(points, of_points));
  line("    normal3f[] normals = " + list(normals, of_normals) + " (interpolation = \"uniform\")");
  line("    uniform token subdivisionScheme = \"none\"");
  line("    uniform token purpose = \"guide\"");
  line("    uniform token physics:approximation = \"convexHull\"");
  line("    rel material:binding:physics = <../Looks/" + look + ">");
  line("}");
}

/// The convex parts of a solid, which rub by its largest look.
void append_hulls(std::string& text, std::span<const ConvexHull> parts, const StyledLevel& level, Looks& looks) {
  if (parts.empty()) return;
  const std::string look = largest_look(level, subsets_by_material(level, 0, looks), looks);
  for (std::size_t i = 0; i < parts.size(); ++i)
    append_hull(text, "hull_" + std::to_string(i + 1), parts[i], pivot_of(level.solid), look);
}

/// Its mesh, or those of its levels of detail, and what it collides with.
void append_meshes(std::string& text, std::span<const StyledLevel> levels, std::span<const ConvexHull> parts,
                   const glm::vec3& pivot, Looks& looks) {
  append_hulls(text, parts, levels.front(), looks);
  const Approximation approximation = !parts.empty()                   ? Approximation::separate_hulls
                                      : is_fruit(levels.front().solid) ? Approximation::convex_hull
                                                                       : Approximation::triangles;
  const auto append = [&](std::size_t number, int indent) {
    append_mesh(text, indent, levels[number], pivot, subsets_by_material(levels[number], number, looks), approximation,
                looks);
  };
  if (levels.size() == 1) return append(0, 2);
  append_line(text, 2, "variantSet \"LOD\" = {");
  for (std::size_t level = 0; level < levels.size(); ++level) {
    append_line(text, 3, "\"LOD" + std::to_string(level) + "\" {");
    append(level, 4);
    append_line(text, 3, "}");
  }
  append_line(text, 2, "}");
}

/// About the centre of mass, as the moments about three axes and the rotation to these.
void append_inertia(std::string& text, const glm::dmat3& inertia) {
  if (inertia == glm::dmat3(0)) return;
  const PrincipalAxes axes = principal_axes(inertia);
  append_line(text, 2, "float3 physics:diagonalInertia = " + exact_tuple(axes.moments));
  append_line(text, 2, "quatf physics:principalAxes = " + exact_tuple(axes.rotation));
}

}  // namespace

std::string settled_text(const std::string& name, const StyledLevel& level, std::span<const ConvexHull> parts,
                         Looks& looks, const ExportOptions& options) {
  std::string text;
  append_line(text, 1, "class \"" + name + "\"");
  append_line(text, 1, "{");
  if (options.hulls <= 1) {
    append_line(text, 2, "over \"mesh\"");
    append_line(text, 2, "{");
    append_line(text, 2, "    bool physics:collisionEnabled = 0");
    append_line(text, 2, "}");
  }
  append_hulls(text, parts, level, looks);
  append_line(text, 1, "}");
  return text;
}

std::string piece_text(const std::string& name, std::span<const StyledLevel> levels, std::span<const ConvexHull> parts,
                       Looks& looks, const ExportOptions& options, std::span<const TextureChoice> choices) {
  const Solid& solid = levels.front().solid;
  const PieceFacts facts = facts_of(solid);
  const glm::vec3 pivot = pivot_of(solid);
  const std::string fruit = solid.origin.fruit.empty() ? solid.name : solid.origin.fruit;
  std::string text;
  const auto line = [&](const std::string& words) { append_line(text, 1, words); };
  line("def Xform \"" + name + "\" (");
  line("    kind = \"component\"");
  line("    displayName = " + quoted(solid.name));
  line(std::string("    prepend apiSchemas = [") + (is_fruit(solid) ? "\"PhysicsRigidBodyAPI\", " : "") +
       "\"PhysicsMassAPI\", \"SemanticsLabelsAPI:category\"]");
  append_custom_data(text, solid, options);
  append_variant_sets(text, levels.size() > 1, choices);
  line(")");
  line("{");
  line("    float physics:mass = " + exact(facts.mass));
  line("    float physics:density = " + exact(facts.density));
  line("    point3f physics:centerOfMass = " + tuple(facts.center - glm::dvec3(pivot), of_points));
  append_inertia(text, facts.inertia);
  line("    token[] semantics:labels:category = [" + quoted(fruit) + "]");
  const std::vector<std::string> own = append_looks(text, levels, looks, !choices.empty());
  append_meshes(text, levels, parts, pivot, looks);
  if (!choices.empty()) append_texture_choices(text, 2, choices, own);
  line("}");
  return text;
}

}  // namespace pomona::usd
