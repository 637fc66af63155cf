// The contract of every reader: it reads the file, or tells what is wrong and where.
#pragma once

#include <functional>

namespace pomona::fuzz {

/// Reads, and aborts if the reader throws anything but an Error with a message, a place in the file and the status of
/// bad or missing data. Returns 0 for libFuzzer.
int told(const std::function<void()>& read);

/// The same for the command line: its errors have no place and the status of wrong use.
int told_words(const std::function<void()>& read);

}  // namespace pomona::fuzz
