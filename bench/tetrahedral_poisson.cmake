# The tetrahedral Poisson solve, for benchmarks and tests alone: CGAL's mesher takes a minute to compile.
find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED)

add_library(pomona_bench_poisson STATIC bench/tetrahedral_mesh.cpp bench/tetrahedral_poisson.cpp)
target_include_directories(pomona_bench_poisson PUBLIC ${PROJECT_SOURCE_DIR})
target_compile_options(pomona_bench_poisson PRIVATE ${POMONA_FLAGS})
# Copies of uninitialized optionals within CGAL and Boost, which g++ 12 warns of.
set_source_files_properties(bench/tetrahedral_mesh.cpp PROPERTIES COMPILE_OPTIONS
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>")
target_link_libraries(pomona_bench_poisson PUBLIC pomona_diffusion PRIVATE CGAL::CGAL Eigen3::Eigen)
