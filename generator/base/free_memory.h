// Memory that is free, but still held.
#pragma once

namespace pomona {

/// Hands back to the system what the heap keeps of memory that was freed. Growing and cutting a salad leaves a third of
/// a gigabyte behind that nobody uses; a step that takes much memory from elsewhere, as OpenGL does, calls this first.
/// Takes some 40 ms.
void give_back_free_memory();

}  // namespace pomona
