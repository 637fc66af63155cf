# What a program that links Pomona's archive needs besides: used when Pomona is built, and by find_package(Pomona).
# Header-only packages are not among them; CGAL, for one, leaves behind only the libraries of its numbers.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(meshoptimizer)
find_dependency(PkgConfig)
pkg_check_modules(POMONA_NEEDS REQUIRED IMPORTED_TARGET
  tbb sleef nettle libhwy gmp mpfr tinygltf tomlplusplus pugixml 2geom libpng zlib OpenEXR
  libmurmurhash)
