#include "generator/piece/slice.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "generator/base/parallel.h"
#include "generator/piece/brown.h"
#include "generator/piece/guided.h"
#include "generator/piece/section_colors.h"
#include "generator/piece/weigh.h"

namespace pomona {

namespace {

/// The largest that are wanted, in the order in which they were cut. Crumbs never are.
std::vector<CutPiece> chosen(std::vector<CutPiece> cut, const PieceChoice& choice) {
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

  std::vector<CutPiece> kept;
  for (const std::size_t i : order) kept.push_back(std::move(cut[i]));
  return kept;
}

/// Takes the mark off interior vertices that no piece shows: nobody will see their colours.
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

/// With the faces still without colours.
Cut cut_open(const SliceTask& task, const CutOptions& options) {
  Cut result = cut(task.grown.sheets, task.knives, options);
  if (!task.choice) return result;
  result.pieces = chosen(std::move(result.pieces), *task.choice);
  return without_unseen(std::move(result));
}

/// The pieces of one fruit as solids.
std::vector<Solid> finished(std::span<const CutPiece> cut, const CrossSection& styled, const SliceTask& task,
                            const Diffuser* diffuser, const SliceOptions& options) {
  std::vector<Solid> pieces = weighed(solids(cut, styled, task.variant, task.name), task.grown, task.variant);
  if (!options.keep_section_colors || diffuser == nullptr) return pieces;
  return with_section_colors(std::move(pieces),
                             std::make_shared<const SectionColors>(task.grown.sheets, task.variant, *diffuser));
}

}  // namespace

std::vector<Slices> slice(std::span<const SliceTask> tasks, const Diffuser* diffuser, const SliceOptions& options) {
  std::vector<Slices> all(tasks.size());
  if (tasks.empty()) return all;

  // Each fruit cut by itself, the faces still without colours.
  std::vector<Cut> cuts(tasks.size());
  parallel_for(tasks.size(), options.threads, [&](std::size_t i) {
    cuts[i] = all[i].times.time("cut", [&] { return cut_open(tasks[i], options.cut); });
  });

  // The colours of all faces, one batch.
  std::vector<CrossSection> sections;
  std::vector<const DiffusionSurfaces*> surfaces;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    sections.push_back(std::move(cuts[i].section));
    surfaces.push_back(&tasks[i].grown.sheets);
  }
  if (diffuser) {
    sections = all.front().times.time("diffuse", [&] { return colored(std::move(sections), surfaces, *diffuser); });
  }

  // What lies in air turns brown, detail is guided along the surfaces, and pieces take their cut faces.
  parallel_for(tasks.size(), options.threads, [&](std::size_t i) {
    const SliceTask& task = tasks[i];
    Slices& slices = all[i];
    slices.warnings = std::move(cuts[i].warnings);
    slices.section = std::move(sections[i]);
    slices.piece_count = cuts[i].pieces.size();
    slices.times.time("style", [&] {
      slices.styled = guided(browned(slices.section, task.grown.sheets, task.variant, options.threads),
                             task.grown.swept, task.variant, options.threads, task.grown.skin.get());
      if (options.pieces) slices.pieces = finished(cuts[i].pieces, slices.styled, task, diffuser, options);
    });
    if (options.one_done) options.one_done();
  });
  return all;
}

Slices slice(const SliceTask& task, const Diffuser* diffuser, const SliceOptions& options) {
  return std::move(slice({&task, 1}, diffuser, options).front());
}

}  // namespace pomona
