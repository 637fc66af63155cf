// The items of a data set: pictures.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cli/batch/asset_work.h"
#include "cli/data/make_picture.h"

namespace pomona {

/// One context of OpenGL for all threads, one at a time: in software it draws on all cores by itself, and drivers do
/// not all bear several at once.
class SharedContext {
 public:
  Image drawn(const Scene& scene, const Style& style, const PictureOptions& options);

 private:
  std::mutex mutex_;
  std::unique_ptr<GlContext> context_;
};

class PictureWork : public ItemWork {
 public:
  /// \param file how the user named the set's file.
  PictureWork(const DataPlan& plan, const std::string& file);

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
  SharedContext context_;
};

}  // namespace pomona
