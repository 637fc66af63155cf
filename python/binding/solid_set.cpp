#include "python/binding/solid_set.h"

#include "cli/options/written_formats.h"
#include "generator/piece/piece_facts.h"
#include "generator/scene/lay_out.h"
#include "python/binding/array_views.h"
#include "python/binding/work.h"
#include "render/deliver/deliver.h"
#include "render/deliver/export_options.h"
#include "render/export/piece_words.h"

namespace pomona {

namespace {

/// One of the solids by itself, where it grew.
class LoneSolid : public Deliverable {
 public:
  LoneSolid(const SolidSet& set, std::size_t number)
      : Deliverable(set.order(), set.taker()),
        scene_(gathered({set.scene().solids.at(number)})),
        can_have_textures_(set.can_have_textures()) {
    scene_.paper = set.scene().paper;
  }

  Delivered deliver(const Order& order, const DeliverOptions& how) const override {
    std::optional<Scene> laid;
    if (any_is(order.outputs, picture_formats)) laid = laid_out(scene_, picture_aspect(order, how));
    return files({.placed = scene_, .shown = laid ? &*laid : nullptr}, order, how);
  }
  const std::vector<Format>& formats() const override { return piece_formats(); }
  bool can_have_textures() const override { return can_have_textures_; }

 private:
  Scene scene_;
  bool can_have_textures_;
};

using Set = std::shared_ptr<SolidSet>;

const Solid& solid_of(const Set& set, std::size_t number) { return set->scene().solids.at(number); }

/// The arrays of a solid, by name.
py::dict solid_arrays(const Set& set, std::size_t number) {
  run_work(py::none(), [&](Telltale&) { set->shown(); });
  const SolidSet::Shown& shown = set->shown();
  const StyledMesh& mesh = shown.meshes.at(number);
  py::dict all;
  all["positions"] = rows_of<float>(mesh.position, set);
  all["normals"] = rows_of<float>(mesh.normal, set);
  all["colors"] = rows_of<float>(mesh.color, set);
  all["parts"] = numbers_of(mesh.part, set);
  all["triangles"] = rows_of<std::uint32_t>(mesh.triangle, set);
  all["cut_faces"] = numbers_of(mesh.cut_face, set);
  all["uv"] = rows_of<float>(mesh.uv, set);
  if (!shown.baked.empty()) {
    const Image& texture = shown.baked.at(number).texture;
    all["texture"] = view_of(&texture.pixels.data()->x, {texture.height, texture.width, 3}, set);
  }
  return all;
}

/// The array of a symmetric matrix, which lists of pieces write column by column.
py::array_t<double> matrix_of(const glm::dmat3& m) {
  py::array_t<double> array({3, 3});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) array.mutable_at(row, column) = m[row][column];
  return array;
}

py::array_t<double> point_of(const glm::dvec3& p) { return py::array_t<double>(3, &p.x); }

py::dict facts_dict(const Set& set, std::size_t number) {
  const PieceFacts facts = facts_of(solid_of(set, number));
  py::dict all;
  all["volume"] = facts.volume;
  all["mass"] = facts.mass;
  all["density"] = facts.density;
  all["center"] = point_of(facts.center);
  all["inertia"] = matrix_of(facts.inertia);
  all["low"] = point_of(facts.low);
  all["high"] = point_of(facts.high);
  return all;
}

/// What a solid is, without looking at its mesh.
py::dict solid_words(const Set& set, std::size_t number) {
  const Solid& solid = solid_of(set, number);
  py::dict all;
  all["name"] = solid.name;
  all["part_names"] = solid.look->part_names;
  all["closed"] = solid.closed;
  all["crumb"] = solid.crumb;
  all["template"] = solid.origin.source;
  all["seed"] = solid.origin.key.seed;
  all["index"] = solid.origin.key.index;
  all["knives"] = solid.origin.knives;
  return all;
}

std::string command_of(const Set& set, std::size_t number) {
  return command_for(solid_of(set, number), export_options(set->order(), deliver_options(*set, set->order())), ".glb");
}

}  // namespace

const SolidSet::Shown& SolidSet::shown() const {
  const std::lock_guard lock(mutex_);
  if (shown_) return *shown_;
  const DeliverOptions how = deliver_options(*this, order());
  Shown made;
  if (const auto bake = bake_options(order())) {
    made.baked = all_baked(scene_.solids, how.texture_style, *bake);
    for (const BakedSolid& baked : made.baked) made.meshes.push_back(textured_mesh(baked));
  } else {
    made.meshes = styled_meshes(scene_.solids, export_options(order(), how));
  }
  return shown_.emplace(std::move(made));
}

void bind_solids(py::module_& module) {
  py::class_<SolidSet, Deliverable, Set>(module, "SolidSet")
      .def("__len__", [](const SolidSet& set) { return set.scene().solids.size(); })
      .def("arrays", &solid_arrays)
      .def("facts", &facts_dict)
      .def("words", &solid_words)
      .def("command", &command_of)
      .def("lone", [](const SolidSet& set, std::size_t number) -> std::shared_ptr<Deliverable> {
        return std::make_shared<LoneSolid>(set, number);
      });
}

}  // namespace pomona
