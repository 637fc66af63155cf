// One item, from its numbers to its files. Nothing is written here, and nothing else has a say in the bytes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/batch/batch_plan.h"
#include "generator/piece/grow.h"
#include "generator/piece/piece_origin.h"
#include "render/export/pov.h"
#include "render/style/style.h"

namespace pomona {

struct MadeItem {
  std::string item;              ///< its folder: "halves/042"
  std::vector<NamedFile> files;  ///< item.json is the last
  std::string error;             ///< why it could not be made; then item.json is all there is
};

/// One individual, for all items that are made of it.
class GrownVariant {
 public:
  GrownVariant(const BatchPlan& plan, const Variation& variation, const BatchVariant& which);

  const BatchVariant& which() const { return which_; }
  const Template& variant() const { return variant_; }
  const GrownFruit& grown() const { return grown_; }
  const PieceOrigin& origin() const { return origin_; }

 private:
  BatchVariant which_;
  Template variant_;
  GrownFruit grown_;
  PieceOrigin origin_;
};

/// \param grown none where growing failed, `growing_error` says how.
MadeItem make_item(const BatchPlan& plan, const BatchVariant& which, const GrownVariant* grown,
                   const std::string& growing_error, const BatchItem& item, const Style& style);

/// What went wrong, in words that are the same each time.
std::string reason_of(const std::exception& error);

/// An estimate of the memory that an item takes while it is made, bytes. docs/guides/batch.md says what it rests on.
std::uint64_t memory_of_an_item(const PlannedEntry& entry);

}  // namespace pomona
