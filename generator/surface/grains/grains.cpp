#include "generator/surface/grains/grains.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/gradient_noise.h"
#include "generator/surface/grains/grain_colors.h"
#include "generator/surface/grains/grain_room.h"
#include "generator/surface/grains/grain_shape.h"
#include "generator/surface/grains/volume_grains.h"
#include "generator/surface/sweep/dart_throwing.h"
#include "generator/surface/sweep/grid_painter.h"
#include "generator/surface/sweep/law_seats.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

constexpr double max_grains = 20'000;
constexpr double max_vertices = 16e6;  // of one kind of grains

/// The longest way across the vertical drawing.
double fruit_size(const Template& fruit) {
  double size = 0;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    if (sketch.vertical.points.empty()) continue;
    glm::dvec2 low = sketch.vertical.points.front(), high = low;
    for (const glm::dvec2& p : sketch.vertical.points) {
      low = glm::dvec2(std::min(low.x, p.x), std::min(low.y, p.y));
      high = glm::dvec2(std::max(high.x, p.x), std::max(high.y, p.y));
    }
    size = std::max(size, glm::distance(low, high));
  }
  return size;
}

/// Dents of one grain.
struct GrainLumps {
  double depth = 0;  ///< as a share of the radius
  std::uint64_t number = 0;
};

/// A point of the grain, drawn in by its dents.
glm::dvec3 dented(const glm::dvec3& p, const GrainLumps& lumps) {
  constexpr double waves = 1.1;  // per radius: a few dents
  const auto far = static_cast<double>(lumps.number % 65536);
  const double noise = gradient_noise(p * waves + glm::dvec3(0.37, 17.31 * far, 0.61), 5);
  return p * (1 - lumps.depth * std::clamp(0.5 + noise, 0.0, 1.0));
}

/// Copies of one painted grain.
class GrainStamp {
 public:
  GrainStamp(const GrainForm& form, const Side& front, const Side& back, double blur) : shape_(unit_grain(form)) {
    GridPainter(painted_, "", front, back, Ramp<double>::constant(blur)).append(shape_);
  }

  void append_to(DiffusionSurfaces& grains, const glm::dvec3& center, const GrainPose& pose, const GrainTint& tint,
                 std::int32_t surface, const GrainLumps& lumps = {}) const {
    const auto first = static_cast<std::uint32_t>(grains.vertex_count());
    for (std::size_t v = 0; v < shape_.position.size(); ++v) {
      const glm::dvec3 p = lumps.depth > 0 ? dented(shape_.position[v], lumps) : shape_.position[v];
      grains.position.emplace_back(center + pose.thickness * p.x + pose.length * p.y + pose.width * p.z);
      grains.front_color.push_back(tinted(painted_.front_color[v], tint));
      grains.back_color.push_back(tinted(painted_.back_color[v], tint));
      grains.blur.push_back(painted_.blur[v]);
      grains.front_hidden.push_back(painted_.front_hidden[v]);
      grains.back_hidden.push_back(painted_.back_hidden[v]);
    }
    for (std::size_t t = 0; t < painted_.triangle_count(); ++t) {
      grains.triangle.push_back(painted_.triangle[t] + glm::uvec3(first));
      grains.surface.push_back(surface);
      grains.front_part.push_back(painted_.front_part[t]);
      grains.back_part.push_back(painted_.back_part[t]);
    }
  }

 private:
  SweptGrid shape_;
  DiffusionSurfaces painted_;
};

Side repainted(Side side, const PaintedColor& color) {
  side.color = color;
  return side;
}

std::int32_t add_surface(DiffusionSurfaces& grains, const std::string& name) {
  grains.surface_names.push_back(name);
  return static_cast<std::int32_t>(grains.surface_names.size() - 1);
}

/// Stamps of one form: one for each look, the sketch's own last.
std::vector<GrainStamp> stamps_of(const GrainSketch& sketch, const GrainForm& form) {
  std::vector<GrainStamp> stamps;
  for (const GrainLook& look : sketch.looks) {
    stamps.emplace_back(form, repainted(sketch.front, look.front), repainted(sketch.back, look.back), sketch.blur);
  }
  stamps.emplace_back(form, sketch.front, sketch.back, sketch.blur);
  return stamps;
}

/// With finer triangles, if more detail is asked for than the template's own. Less leaves them: they have few.
GrainForm finer(GrainForm form, double detail) {
  form.around = refined(form.around, std::max(detail, 1.0), form.around);
  form.along = refined(form.along, std::max(detail, 1.0), form.along);
  return form;
}

/// \throws Error (bad_data) for grains with more vertices than memory has room for.
void refuse_too_fine(const Template& fruit, const GrainSketch& sketch, const GrainForm& form, std::size_t count) {
  if (static_cast<double>(count) * form.around * form.along > max_vertices) {
    refuse_entry(fruit, "grains", sketch.name, "more than 16 million vertices", "lower around or along, or the detail");
  }
}

/// Grains of a volume that are half as large as the largest, or a quarter, need fewer triangles; the least is 20.
std::vector<GrainForm> forms_of(const GrainSketch& sketch, double detail) {
  std::vector<GrainForm> forms{sketch.form};
  for (int halvings = 1; sketch.volume && halvings <= 2; ++halvings) {
    GrainForm form = forms.back();
    form.around = std::max(std::min(5, form.around), form.around * 3 / 4);
    form.along = std::max(std::min(4, form.along), form.along * 3 / 4);
    forms.push_back(form);
  }
  for (GrainForm& form : forms) form = finer(form, detail);
  return forms;
}

/// Which of the forms a grain has. It depends on its number alone, so all variants agree.
std::size_t form_of(const GrainSketch& sketch, std::uint64_t number, std::size_t count) {
  if (!sketch.volume) return 0;
  const double share = volume_size(*sketch.volume, static_cast<std::size_t>(number), count) / sketch.volume->to;
  return share >= 0.5 ? 0 : share >= 0.25 ? 1 : 2;
}

void append_grains(DiffusionSurfaces& grains, const GrainSketch& sketch, const std::vector<GrainForm>& forms,
                   const std::vector<Dart>& darts, const GrainDraws& draws) {
  std::vector<std::vector<GrainStamp>> stamps;  // by form, then by look
  for (const GrainForm& form : forms) stamps.push_back(stamps_of(sketch, form));
  const std::int32_t surface = add_surface(grains, sketch.name);
  for (const Dart& dart : darts) {
    const std::vector<GrainStamp>& looks = stamps[form_of(sketch, dart.number, darts.size())];
    const GrainStamp& stamp = dart.pose.look < 0 ? looks.back() : looks[static_cast<std::size_t>(dart.pose.look)];
    const GrainLumps lumps{sketch.volume ? sketch.volume->lumps : 0, dart.number};
    stamp.append_to(grains, dart.center, dart.pose, drawn_tint(sketch, dart.number, draws), surface, lumps);
  }
}

/// A core in every grain that looks as its sketch says; those with another look have none.
void append_cores(DiffusionSurfaces& grains, const GrainSketch& sketch, const GrainCore& core, const GrainForm& form,
                  const std::vector<Dart>& darts, const GrainDraws& draws) {
  const GrainStamp stamp(form, core.front, core.back, core.blur);
  const std::int32_t surface = add_surface(grains, sketch.name + "-core");
  for (const Dart& dart : darts) {
    if (dart.pose.look != GrainPose::own_look) continue;
    GrainPose pose = dart.pose;
    const glm::dvec3 center = dart.center + pose.length * (2 * core.shift);
    pose.thickness *= core.form.thickness;
    pose.length *= core.form.length;
    pose.width *= core.form.width;
    stamp.append_to(grains, center, pose, drawn_tint(sketch, dart.number, draws), surface);
  }
}

/// The grains of one kind with their cores.
void append_kind(DiffusionSurfaces& grains, const Template& fruit, const GrainSketch& sketch,
                 const std::vector<Dart>& darts, const GrainDraws& draws, double detail) {
  const std::vector<GrainForm> forms = forms_of(sketch, detail);
  refuse_too_fine(fruit, sketch, forms.front(), darts.size());
  append_grains(grains, sketch, forms, darts, draws);
  for (const GrainCore& core : sketch.cores) {
    const GrainForm form = finer(core.form, detail);
    refuse_too_fine(fruit, sketch, form, darts.size());
    append_cores(grains, sketch, core, form, darts, draws);
  }
}

/// Leaves out the grains of empty places.
std::vector<Dart> filled(std::vector<Dart> darts, const GrainSketch& sketch, const GrainDraws& draws) {
  if (sketch.ground.share >= 1) return darts;
  std::erase_if(darts, [&](const Dart& dart) {
    return draws.places.uniform(draws_per_candidate * dart.number + 6) >= sketch.ground.share;
  });
  return darts;
}

/// The walls that grains of this kind keep clear of.
GrainWalls walls_of(const Template& fruit, const GrainSketch& sketch, const SweepOptions& options) {
  std::vector<SweptGrid> meshes;
  for (const int surface : sketch.spacing.clear_of) {
    std::vector<SweptGrid> more = swept_grids(fruit, fruit.surfaces.at(static_cast<std::size_t>(surface)), options);
    std::move(more.begin(), more.end(), std::back_inserter(meshes));
  }
  return {meshes, 0.7 * std::max({sketch.form.length, sketch.form.width, sketch.form.thickness})};
}

/// Grains inside a surface keep clear of all that were placed before.
std::vector<Dart> filled_volume(const Template& fruit, const GrainSketch& sketch, const GrainDraws& draws,
                                VariantKey key, const SweepOptions& options,
                                const std::vector<std::vector<Dart>>& placed) {
  std::vector<GrainObstacle> others;
  for (std::size_t kind = 0; kind < placed.size(); ++kind) {
    for (const Dart& dart : placed[kind]) others.push_back({dart.center, body_of(dart.pose, fruit.grains[kind].form)});
  }
  try {
    return volume_darts(fruit, sketch, draws, key, options, others);
  } catch (const NoRoom&) {
    refuse_entry(fruit, "grains", sketch.name, "there is no room for so many",
                 "lower the share of the volume, the wall or the gap");
  }
}

const LawSketch& law_of(const Template& fruit, const GrainSketch& sketch) {
  return fruit.laws.at(static_cast<std::size_t>(*sketch.spacing.law));
}

}  // namespace

DiffusionSurfaces scatter_grains(const Template& fruit, VariantKey key, const SweepOptions& options) {
  DiffusionSurfaces grains;
  grains.part_names = fruit.parts;
  const SweepOptions placing = for_placing(options);
  const double size = fruit_size(fruit);
  double expected = 0;
  std::vector<std::vector<Dart>> placed;
  std::map<std::vector<int>, GrainWalls> walls;  // by the surfaces that kinds keep clear of
  for (const GrainSketch& sketch : fruit.grains) {
    // Refuse what would take too long before placing the first grain.
    const GrainDraws draws = grain_draws(key, sketch.name);
    const SurfaceSketch& surface = fruit.surfaces.at(static_cast<std::size_t>(sketch.surface));
    if (sketch.volume) {
      expected += volume_room(sketch, surface.vertical);
      if (expected > max_grains)
        refuse_entry(fruit, "grains", sketch.name, "more than 20 000 grains", "make the smallest larger");
      placed.push_back(filled_volume(fruit, sketch, draws, key, placing, placed));
      append_kind(grains, fruit, sketch, placed.back(), draws, options.detail);
      continue;
    }
    const std::vector<SweptGrid> grids = swept_grids(fruit, surface, placing);
    std::vector<GrainTarget> targets;
    if (sketch.spacing.law) {
      expected += law_room(law_of(fruit, sketch), surface.vertical);
    } else {
      if (!(sketch.spacing.poisson_radius >= 1e-3 * size)) {
        refuse_entry(fruit, "grains", sketch.name, "their spacing is below 1/1000 of the fruit",
                     "make it the distance between grains");
      }
      targets = grain_targets(grids, sketch, draws.folds);
      expected += room_for_grains(targets, sketch);
    }
    if (expected > max_grains)
      refuse_entry(fruit, "grains", sketch.name, "more than 20 000 grains", "make their spacing larger");

    std::vector<Dart> others;
    for (const int kind : sketch.spacing.apart_from) {
      const std::vector<Dart>& known = placed.at(static_cast<std::size_t>(kind));
      others.insert(others.end(), known.begin(), known.end());
    }
    std::vector<Dart> darts;
    if (!sketch.spacing.law) {
      darts = thrown_darts(targets, sketch, draws, options.threads, others);
    } else if (!grids.empty()) {
      darts = seated_darts(law_of(fruit, sketch), surface.vertical, grids.front(), sketch, draws, key);
    }
    darts = filled(std::move(darts), sketch, draws);
    if (const std::vector<int>& clear_of = sketch.spacing.clear_of; !clear_of.empty()) {
      if (!walls.contains(clear_of)) walls.emplace(clear_of, walls_of(fruit, sketch, placing));
      darts = with_room(std::move(darts), sketch, walls.at(clear_of), others);
    }
    placed.push_back(std::move(darts));
    append_kind(grains, fruit, sketch, placed.back(), draws, options.detail);
  }
  return grains;
}

}  // namespace pomona
