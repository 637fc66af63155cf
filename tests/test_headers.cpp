// Nothing of its own: CMake precompiles test_headers.h along with a source.
