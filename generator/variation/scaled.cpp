#include "generator/variation/scaled.h"

namespace pomona {

namespace {

void scale(Curve& curve, double factor) {
  for (glm::dvec2& p : curve.points) p *= factor;
}

void scale(Ramp<double>& lengths, double factor) {
  for (auto& stop : lengths.stops) stop.value *= factor;
}

void scale(Side& side, double factor) {
  if (side.cells) scale(side.cells->raise, factor);
  for (SpotSketch& spot : side.spots) {
    spot.spacing *= factor;
    spot.size_min *= factor;
    spot.size_max *= factor;
    spot.relief *= factor;
  }
}

void scale(SurfaceSketch& surface, double factor) {
  scale(surface.vertical, factor);
  for (Curve& loop : surface.horizontal) scale(loop, factor);
  if (surface.reference)
    surface.reference = ReferenceRadii{surface.reference->inner * factor, surface.reference->outer * factor};
  scale(surface.off.x, factor);
  scale(surface.off.z, factor);
  scale(surface.blur.along, factor);
  scale(surface.front, factor);
  scale(surface.back, factor);
}

void scale(SheetSketch& sheet, double factor) {
  scale(sheet.inner, factor);
  scale(sheet.outer, factor);
  scale(sheet.loop, factor);
  scale(sheet.thickness, factor);
  scale(sheet.rib.height, factor);
  for (double* length : {&sheet.ruffle.height, &sheet.gap, &sheet.stand_off, &sheet.sway, &sheet.stray, &sheet.blur})
    *length *= factor;
}

void scale(GrainVolume& volume, double factor) {
  for (double* length : {&volume.from, &volume.to, &volume.wall, &volume.apart}) *length *= factor;
  for (auto& stop : volume.near_skin.stops) stop.at *= factor;
}

void scale(GrainSketch& grain, double factor) {
  grain.spacing.poisson_radius *= factor;
  grain.form.length *= factor;
  grain.form.width *= factor;
  grain.form.thickness *= factor;
  grain.stance.sink *= factor;
  if (grain.volume) scale(*grain.volume, factor);
  grain.blur *= factor;
  scale(grain.front, factor);
  scale(grain.back, factor);
  for (GrainCore& core : grain.cores) {
    core.blur *= factor;  // its sizes are shares of the grain's
    scale(core.front, factor);
    scale(core.back, factor);
  }
}

/// The blur in the file has the file's unit.
void scale(MeshSketch& mesh, double factor) {
  mesh.unit *= factor;
  mesh.at *= factor;
  if (!mesh.paint) return;
  MeshPaint& paint = *mesh.paint;
  scale(paint.blur.along, factor);
  if (paint.ramps_from) *paint.ramps_from *= factor;
  scale(paint.front, factor);
  scale(paint.back, factor);
}

void scale(LawSketch& law, double factor) {
  scale(law.spacing, factor);
  scale(law.envelope, factor);
  law.hollow *= factor;
}

/// What is placed is shared and stays as it is; instances are scaled by their size when they are set.
void scale(PlaceSketch& place, double factor) {
  scale(place.size, factor);
  place.sink *= factor;
  if (place.press) {
    place.press->gap *= factor;
    if (place.press->root) *place.press->root *= factor;
  }
  if (!place.stalk) return;
  place.stalk->rise *= factor;
  place.stalk->root_width *= factor;
  place.stalk->top_width *= factor;
  place.stalk->depth *= factor;
}

}  // namespace

Template scaled(Template fruit, double factor) {
  for (SurfaceSketch& surface : fruit.surfaces) scale(surface, factor);
  for (SheetSketch& sheet : fruit.sheets) scale(sheet, factor);
  for (LawSketch& law : fruit.laws) scale(law, factor);
  for (GrainSketch& grain : fruit.grains) scale(grain, factor);
  for (PlaceSketch& place : fruit.places) scale(place, factor);
  for (MeshSketch& mesh : fruit.meshes) scale(mesh, factor);
  return fruit;
}

}  // namespace pomona
