// Memory that is free, but still held.
#pragma once

namespace pomona {

/// Hands back to the system what the heap keeps of memory that was freed. Growing and cutting a salad leaves a third of
/// a gigabyte behind that nobody uses; a step that takes much memory from elsewhere, as OpenGL does, calls this first.
/// Takes some 40 ms.
void give_back_free_memory();

/// From now on the heap holds what is freed, up to 128 MB at its end, and blocks of up to 16 MB come from it. Otherwise
/// glibc would give each larger block back to the system and ask for it again, page by page: a tenth of the time of a
/// new variant. Twice as much of both bought nothing more, and took memory. For programs, once, at their start.
void keep_free_memory();

/// From now on all threads share so many heaps. glibc would make one for each thread, up to eight a core, and what is
/// freed in one serves no other: of a server, each of whose requests comes on another thread, the first dozen would
/// each bring in the memory for their grids anew, two fifths of their time. For programs, before their threads.
void share_heaps(int most);

}  // namespace pomona
