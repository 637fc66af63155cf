// Memory that is free, but still held.
#pragma once

namespace pomona {

/// Hands back to the system what the heap keeps of memory that was freed. Growing and cutting a salad leaves a third of
/// a gigabyte behind that nobody uses; a step that takes much memory from elsewhere, as OpenGL does, calls this first.
/// Takes some 40 ms.
void give_back_free_memory();

/// From now on the heap holds what is freed, up to 64 MB, and blocks of up to 4 MB come from it. Otherwise glibc would
/// give each larger block back to the system and ask for it again, page by page. For programs, once, at their start.
void keep_free_memory();

}  // namespace pomona
