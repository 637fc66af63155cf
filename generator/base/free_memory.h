// Memory that was freed, but that the heap still holds.
#pragma once

namespace pomona {

/// Returns freed memory from the heap to the system. After a salad is grown and cut, a third of a gigabyte is unused. A
/// step that takes much memory from elsewhere, such as OpenGL, calls this first. Takes some 40 ms.
void give_back_free_memory();

/// From now on the heap keeps up to 128 MB of freed memory at its end, and blocks of up to 16 MB come from the heap.
/// Otherwise glibc would return each larger block to the system and ask for it again, page by page, which takes a tenth
/// of the time of a new variant. Larger limits were not faster. A program calls this once, at its start.
void keep_free_memory();

/// From now on all threads share at most this many heaps. glibc would make one for each thread, up to eight per core,
/// and memory freed in one heap cannot be used by another. In a server, where each request comes on another thread, the
/// first dozen requests would each need new memory for their grids, which takes two fifths of their time. A program
/// calls this before it starts threads.
void share_heaps(int max);

}  // namespace pomona
