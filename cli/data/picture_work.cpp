#include "cli/data/picture_work.h"

#include <algorithm>
#include <filesystem>

#include "cli/exhausted.h"
#include "cli/options/find_style.h"
#include "generator/base/beside.h"
#include "generator/base/error.h"
#include "generator/base/version.h"
#include "render/strokes/ink_on_picture.h"
#include "render/strokes/scene_strokes.h"

namespace pomona {

Image SharedPainter::drawn(const Scene& scene, const Style& style, const PictureOptions& options) {
  // Lines need no OpenGL: meanwhile another thread may have it.
  Style paint = style;
  paint.ink = false;
  Image picture;
  thread_.start([&](const CurrentGl& gl) { picture = draw_scene(gl, scene, paint, options); }).get();
  if (!style.ink) return picture;
  const StrokeOptions strokes{.width = options.width, .height = options.height, .threads = options.threads};
  return with_ink(std::move(picture), scene_strokes(scene, style, strokes), options.threads);
}

PictureWork::PictureWork(const DataPlan& plan, const std::string& words)
    : plan_(plan),
      tools_{plan,
             {},
             std::string("pomona ") + version,
             words,
             [this](const Scene& scene, const Style& style, const PictureOptions& options) {
               return painter_.drawn(scene, style, options);
             }},
      ready_(plan.templates) {
  for (const std::string& style : plan.data.styles)
    tools_.styles[style] = find_style(style_beside(plan.data.file, style));
}

std::vector<RecordedEntry> PictureWork::entries() const { return {{"pictures", plan_.data.count, 1}}; }

std::string PictureWork::recipe(std::size_t, std::int64_t number) const {
  return picture_recipe(plan_, tools_.program, number);
}

std::uint64_t PictureWork::memory_of_an_item(std::size_t) const {
  constexpr std::uint64_t of_a_picture = 150'000'000, of_a_fruit = 20'000'000, of_a_pixel = 400;
  const auto pixels = static_cast<std::uint64_t>(plan_.data.width) * static_cast<std::uint64_t>(plan_.data.height);
  return of_a_picture + of_a_fruit * static_cast<std::uint64_t>(plan_.data.fruits.high) + of_a_pixel * pixels;
}

ReadyTemplate PictureWork::ready(const std::string& word) {
  for (const PlannedKind& kind : plan_.kinds) {
    const auto found = std::find(kind.words.begin(), kind.words.end(), word);
    if (found == kind.words.end()) continue;
    const std::size_t fruit = kind.templates[static_cast<std::size_t>(found - kind.words.begin())];
    const ReadyTemplates::Ready& ready = ready_.of(fruit);
    if (!ready.variation) throw Error(ExitStatus::bad_data, ready.error);
    // Both live as long as this work.
    return {&plan_.templates[fruit].fruit, {std::shared_ptr<const void>(), &*ready.variation}};
  }
  throw Error(ExitStatus::bug, "no kind has the template \"" + word + "\"");
}

MadeItem PictureWork::made(std::int64_t number) {
  ComposeOptions composing;
  composing.ready_template = [this](const std::string& word) { return ready(word); };
  composing.detail = plan_.data.detail;
  composing.threads = {1};
  composing.organs = true;
  MadeItem made{.item = path_of(entries().front(), number), .files = {}, .error = {}};
  try {
    made.files = picture_files(tools_, number, composing);
  } catch (const Error& error) {
    if (error.status() == ExitStatus::helper_missing) throw;
    made.error = reason_of(error);
  } catch (const std::exception& error) {
    if (exhausted(error)) throw;
    made.error = reason_of(error);
  }
  if (!made.error.empty()) made.files = {failed_picture(tools_, number, made.error)};
  return made;
}

void PictureWork::make(std::size_t, std::span<const std::int64_t> numbers, const Put& put) {
  for (const std::int64_t number : numbers) put(made(number));
}

}  // namespace pomona
