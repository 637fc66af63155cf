// The table of an order's options, as JSON: documents, schemas and other programs are made of it.
#pragma once

#include <string>

namespace pomona {

/// `pomona pages options`: an object for each option, in the order of the table.
std::string option_list();

}  // namespace pomona
