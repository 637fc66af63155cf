// What every reader owes to whoever wrote the file: it reads it, or tells what is wrong and where.
#pragma once

#include <functional>

namespace pomona::fuzz {

/// Reads, and ends the program where the reader throws anything but an Error that has a message, a place in the file
/// and the status of bad or missing data. Returns 0, as libFuzzer wants.
int told(const std::function<void()>& read);

/// The same for words of the command line, which have no place and the status of a wrong use.
int told_words(const std::function<void()>& read);

}  // namespace pomona::fuzz
