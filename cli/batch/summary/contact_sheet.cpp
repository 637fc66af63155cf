#include "cli/batch/summary/contact_sheet.h"

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"
#include "generator/base/marked_text.h"
#include "generator/base/xml_text.h"

namespace pomona {

ContactSheet::ContactSheet(const RecordedBatch& batch) {
  const std::string_view page = contact_sheet_files().front().text, mark = "@ITEMS@";
  const std::size_t at = page.find(mark);
  const std::string about =
      json_in_script(nlohmann::ordered_json({{"name", batch.name}, {"program", batch.program}, {"seed", batch.seed}}));
  before_ = filled(page.substr(0, at), {{"@BATCH@", about}, {"@TITLE@", xml_escaped(batch.title)}});
  after_ = filled(page.substr(at + mark.size()), {{"@SCRIPT@", std::string(contact_sheet_files().back().text)}});
}

std::string ContactSheet::row(const RecordedItem& item) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const RecordedFile& file : item.files) files.push_back(file.name);
  // A thousandth of a millilitre is precise enough for sorting.
  const double millilitres = static_cast<double>(static_cast<std::int64_t>(item.volume * 1e9)) / 1e3;
  const nlohmann::ordered_json row = {item.item,   item.template_name, item.seed, item.knives,
                                      item.pieces, millilitres,        files,     item.error};
  return json_in_script(row);
}

}  // namespace pomona
