// The items of a data set: pictures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/batch/asset_work.h"
#include "cli/data/make_picture.h"
#include "render/diffusion/gl_thread.h"

namespace pomona {

/// Draws for all threads on one of its own. In software OpenGL draws on all cores by itself; and drivers do not all
/// bear contexts on threads that they do not see end.
class SharedPainter {
 public:
  SharedPainter() : thread_(std::make_unique<GlContext>()) {}
  Image drawn(const Scene& scene, const Style& style, const PictureOptions& options);

 private:
  GlThread thread_;
};

class PictureWork : public ItemWork {
 public:
  /// \param words of the set in commands that make its pictures again: "set.toml". \throws Error (helper_missing) if
  /// there is no OpenGL
  PictureWork(const DataPlan& plan, const std::string& words);

  std::vector<RecordedEntry> entries() const override;
  std::string recipe(std::size_t entry, std::int64_t number) const override;
  std::uint64_t memory_of_an_item(std::size_t entry) const override;
  void make(std::size_t entry, std::span<const std::int64_t> numbers, const Put& put) override;

 private:
  MadeItem made(std::int64_t number);
  ReadyTemplate ready(const std::string& word);

  const DataPlan& plan_;
  PictureTools tools_;
  ReadyTemplates ready_;
  SharedPainter painter_;
};

}  // namespace pomona
