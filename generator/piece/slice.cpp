#include "generator/piece/slice.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/cut/section/section_crumbs.h"
#include "generator/knife/turned_wedges.h"
#include "generator/mesh/box.h"
#include "generator/piece/brown.h"
#include "generator/piece/guided.h"
#include "generator/piece/organs.h"
#include "generator/piece/section_colors.h"
#include "generator/piece/weigh.h"

namespace pomona {

namespace {

/// All but crumbs: the smallest pieces are left out as long as they are less than a crumb together.
std::vector<std::size_t> without_crumbs(const std::vector<CutPiece>& cut, double crumb) {
  double whole = 0;
  std::vector<std::size_t> crumbs, kept;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    whole += cut[i].volume;
    if (cut[i].crumb) crumbs.push_back(i);
  }
  std::stable_sort(crumbs.begin(), crumbs.end(),
                   [&](std::size_t a, std::size_t b) { return cut[a].volume < cut[b].volume; });
  double left_out = 0;
  std::vector<std::uint8_t> goes(cut.size(), 0);
  for (const std::size_t i : crumbs) {
    left_out += cut[i].volume;
    if (left_out >= crumb * whole) break;
    goes[i] = 1;
  }
  for (std::size_t i = 0; i < cut.size(); ++i)
    if (!goes[i]) kept.push_back(i);
  return kept;
}

/// The wanted pieces, in the order of cutting.
std::vector<std::size_t> chosen(const std::vector<CutPiece>& cut, const PieceChoice& choice) {
  if (choice.only > 0) {
    const auto only = static_cast<std::size_t>(choice.only - 1);
    return only < cut.size() ? std::vector<std::size_t>{only} : std::vector<std::size_t>{};
  }

  // The largest pieces; crumbs never count.
  double whole = 0;
  for (const CutPiece& piece : cut) whole += piece.volume;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const bool is_wanted = cut[i].volume >= choice.smallest * whole && cut[i].volume <= choice.largest * whole;
    if (is_wanted && !cut[i].crumb) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cut[a].volume > cut[b].volume; });
  if (choice.take > 0 && order.size() > static_cast<std::size_t>(choice.take)) {
    order.resize(static_cast<std::size_t>(choice.take));
  }
  std::sort(order.begin(), order.end());
  return order;
}

/// The result of cutting a fruit.
struct OpenedFruit {
  Cut cut;                                 ///< the cut with the wanted pieces
  std::vector<int> number;                 ///< number of each piece in the order of cutting, from 1
  std::vector<std::uint8_t> on_skin = {};  ///< per part: whether any piece, wanted or not, has it on its skin
  std::size_t piece_count = 0;             ///< wanted or not
};

OpenedFruit opened(Cut cut) {
  OpenedFruit fruit{.cut = std::move(cut), .number = {}};
  fruit.piece_count = fruit.cut.pieces.size();
  for (std::size_t i = 0; i < fruit.piece_count; ++i) fruit.number.push_back(static_cast<int>(i + 1));
  fruit.on_skin.resize(fruit.cut.section.part_names.size());
  for (const CutPiece& piece : fruit.cut.pieces)
    for (const std::int32_t part : piece.part) fruit.on_skin.at(static_cast<std::size_t>(part)) = 1;
  return fruit;
}

/// Only these pieces, with their numbers.
OpenedFruit with_pieces(OpenedFruit fruit, const std::vector<std::size_t>& wanted) {
  std::vector<CutPiece> kept;
  std::vector<int> number;
  for (const std::size_t i : wanted) {
    kept.push_back(std::move(fruit.cut.pieces[i]));
    number.push_back(fruit.number[i]);
  }
  fruit.cut.pieces = std::move(kept);
  fruit.number = std::move(number);
  return fruit;
}

/// Unmarks interior vertices that no piece shows, because nobody sees their colours.
Cut without_unseen(Cut cut) {
  std::vector<std::uint8_t> seen(cut.section.position.size(), 0);
  for (const CutPiece& piece : cut.pieces) {
    for (const CutPiece::CapTriangle& cap : piece.caps) {
      const glm::uvec3& t = cut.section.triangle[cap.triangle];
      for (int k = 0; k < 3; ++k) seen[t[k]] = 1;
    }
  }
  for (std::size_t v = 0; v < seen.size(); ++v) cut.section.interior[v] &= seen[v];
  return cut;
}

/// The faces have no colours yet.
OpenedFruit cut_open(const SliceTask& task, const CutOptions& options) {
  CutOptions how = options;
  how.spared_parts = task.variant.spared;
  how.held_parts = task.variant.held;
  const bool is_drawing = task.origin.growing.as_drawn;
  OpenedFruit fruit = opened(is_drawing ? cut(task.grown.sheets, task.knives, how)
                                        : cut(task.grown.sheets, turned_wedges(task.knives, task.variant), how));
  const bool by_number = task.choice && task.choice->only > 0;
  if (!task.crumbs && !by_number) {
    const std::vector<std::size_t> kept = without_crumbs(fruit.cut.pieces, options.crumb);
    fruit = with_pieces(std::move(fruit), kept);
  }
  if (!task.choice) return fruit;
  const std::vector<std::size_t> wanted = chosen(fruit.cut.pieces, *task.choice);
  fruit = with_pieces(std::move(fruit), wanted);
  fruit.cut = without_unseen(std::move(fruit.cut));
  return fruit;
}

/// The task's origin, with the cut. Cuts that no command of the program makes have none.
PieceOrigin origin_of(const SliceTask& task, const CutOptions& how) {
  PieceOrigin origin = task.origin;
  origin.fruit = task.variant.name;
  origin.variant = task.name;
  origin.knives.clear();
  for (const Knife& knife : task.knives) origin.knives.push_back(knife.text);
  origin.coarse = !same_cut(how, CutOptions{});
  if (origin.coarse && !same_cut(how, coarse_cut)) origin.source.clear();
  return origin;
}

/// The spots that reach into the box of a piece.
std::vector<Spot> raised_on(const Solid& piece, const std::vector<Spot>& all) {
  std::vector<Spot> near;
  if (all.empty() || piece.mesh.position.empty()) return near;
  const Box<float> box = box_around(piece.mesh.position);
  const glm::dvec3 low(box.low), high(box.high);
  for (const Spot& spot : all) {
    const glm::dvec3 away = spot.center - glm::clamp(spot.center, low, high);
    if (glm::dot(away, away) < reach_of(spot) * reach_of(spot)) near.push_back(spot);
  }
  return near;
}

/// The pieces of one fruit as solids.
std::vector<Solid> finished(const OpenedFruit& fruit, const CrossSection& styled, const SliceTask& task,
                            const Diffuser* diffuser, const SliceOptions& options) {
  std::vector<Solid> pieces =
      weighed(solids(fruit.cut.pieces, styled, task.variant, task.name), task.grown, task.variant);
  if (options.organs)
    pieces = with_organs(std::move(pieces), task.grown, task.variant);
  else
    for (Solid& piece : pieces) piece.mesh.instance.clear();  // told with the organs or not at all
  if (!pieces.empty()) pieces[0].own_look().on_skin = fruit.on_skin;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].origin = origin_of(task, options.cut);
    pieces[i].look = pieces[0].look;
    pieces[i].raised = raised_on(pieces[i], task.grown.raised);
    pieces[i].origin.number = fruit.number[i];
    pieces[i].origin.pieces = static_cast<int>(fruit.piece_count);
  }
  if (!options.keep_section_colors || diffuser == nullptr) return pieces;
  return with_section_colors(std::move(pieces),
                             std::make_shared<const SectionColors>(task.grown.sheets, task.variant, *diffuser));
}

}  // namespace

std::vector<Slices> slice(std::span<const SliceTask> tasks, const Diffuser* diffuser, const SliceOptions& options) {
  std::vector<Slices> all(tasks.size());
  if (tasks.empty()) return all;

  // Cuts each fruit by itself; the faces have no colours yet.
  std::vector<OpenedFruit> fruits(tasks.size());
  parallel_for(tasks.size(), options.threads, [&](std::size_t i) {
    fruits[i] = all[i].times.time("cut", [&] { return cut_open(tasks[i], options.cut); });
  });

  // Diffuses the colours of all faces as one batch.
  std::vector<CrossSection> sections;
  std::vector<const DiffusionSurfaces*> surfaces;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    sections.push_back(std::move(fruits[i].cut.section));
    surfaces.push_back(&tasks[i].grown.sheets);
  }
  if (diffuser) {
    sections = all.front().times.time("diffuse", [&] { return colored(std::move(sections), surfaces, *diffuser); });
  }

  // Browns the faces, guides detail along the surfaces, and gives pieces their cut faces.
  parallel_for(tasks.size(), options.threads, [&](std::size_t i) {
    const SliceTask& task = tasks[i];
    Slices& slices = all[i];
    slices.warnings = std::move(fruits[i].cut.warnings);
    slices.section = std::move(sections[i]);
    slices.piece_count = fruits[i].cut.pieces.size();
    slices.times.time("style", [&] {
      slices.styled = guided(browned(slices.section, task.grown.sheets, task.variant, options.threads),
                             task.grown.swept, task.variant, options.threads, task.grown.skin.get());
      if (options.pieces) {
        fruits[i].cut.pieces = browned(std::move(fruits[i].cut.pieces), task.grown.sheets, task.variant);
        slices.pieces = finished(fruits[i], slices.styled, task, diffuser, options);
      }
      if (task.crumbs) return;
      slices.section = without_crumbs(std::move(slices.section));
      slices.styled = without_crumbs(std::move(slices.styled));
    });
    if (options.one_done) options.one_done();
  });
  return all;
}

Slices slice(const SliceTask& task, const Diffuser* diffuser, const SliceOptions& options) {
  return std::move(slice({&task, 1}, diffuser, options).front());
}

}  // namespace pomona
