# How every part of Pomona is compiled, and the functions its folders use.

# The same bits from every compiler and processor: no fused operations, no reordering of floating point.
set(POMONA_FLAGS -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 sees overlapping copies in "literal" + std::string that are not there (its bug 105651).
  list(APPEND POMONA_FLAGS -Wno-restrict)
elseif(POMONA_UNITY)
  # clang warns where a local hides a name that another source of the unit has.
  list(APPEND POMONA_FLAGS -Wno-shadow)
endif()
if(POMONA_WERROR)
  list(APPEND POMONA_FLAGS -Werror)
endif()
if(POMONA_SANITIZE)
  # GCC documents that sanitizers make it report values as uninitialized that are not (std::variant, std::optional).
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=address,undefined)
  # front() of an empty deque and its like lie within memory that is allowed.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

# A shared library can hold all of it: the Python module is one. Hidden symbols cannot be replaced from outside, so the
# compiler inlines as in a program, and the program is as fast as without.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

if(POMONA_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# ccache would not keep what includes a precompiled header unless told that it may: ccache's manual, "Precompiled
# headers".
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# Half of the compiler's time goes into reading the same headers, and much of the rest into compiling what they hold
# once more for every file (docs/guides/building.md). So a folder's sources are compiled some ten at once.
function(pomona_together name)
  if(POMONA_UNITY)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
  endif()
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# pomona_library(base SOURCES a.cpp b.cpp ALONE b.cpp DEPENDS pomona_x PRIVATE_DEPENDS heavy::package)
# One static library a folder. DEPENDS is seen by users of the headers; a heavy package is PRIVATE. Sources named ALONE
# are never compiled together with others: they include a heavy package, or name something as another source does.
function(pomona_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;ALONE;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(pomona_${name} STATIC ${ARG_SOURCES})
  pomona_together(pomona_${name} ${ARG_ALONE})
  target_include_directories(pomona_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(pomona_${name} PRIVATE ${POMONA_FLAGS})
  target_link_libraries(pomona_${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY POMONA_LIBRARIES pomona_${name})
endfunction()

# pomona_program(pomona SOURCES main.cpp DEPENDS pomona_export PRIVATE_DEPENDS CLI11::CLI11)
# The program itself; it comes to lie at the top of the build folder.
function(pomona_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;ALONE;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  pomona_together(${name} ${ARG_ALONE})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${POMONA_FLAGS})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} ${ARG_PRIVATE_DEPENDS})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endfunction()

# pomona_test(sweep_test SOURCES sweep_test.cpp DEPENDS pomona_surface)
# One GoogleTest program; its cases appear in ctest one by one. What it tests is compiled as ever; the test itself with
# less optimisation, and with the headers of tests/test_headers.h compiled once for all tests. One that hangs is ended
# after ctest's 1500 seconds: sanitizers take ten times as long.
function(pomona_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE ${POMONA_FLAGS} -O1)
  target_compile_definitions(${name} PRIVATE POMONA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gmock GTest::gtest_main)
  if(POMONA_UNITY)
    target_precompile_headers(${name} REUSE_FROM pomona_test_headers)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST)
endfunction()

# pomona_bundle(page_script ENTRY render/page/page.js)
# Joins a module with all that it imports into one script for a page, still to be read by people: ${page_script} is its
# file, page_script.js. No list of modules: each says itself what it needs.
find_program(POMONA_ESBUILD esbuild REQUIRED)
function(pomona_bundle name)
  cmake_parse_arguments(ARG "" "ENTRY" "" ${ARGN})
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.js)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/render/page/*.js ${PROJECT_SOURCE_DIR}/cli/studio/page/*.js
    ${PROJECT_SOURCE_DIR}/cli/batch/*.js)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${POMONA_ESBUILD} ${ARG_ENTRY} --bundle --format=iife --target=es2022 --charset=utf8 --log-level=warning
      "--banner:js='use strict';" --outfile=${output}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DEPENDS ${sources}
    VERBATIM)
  set(${name} ${output} PARENT_SCOPE)
endfunction()

# pomona_embed(shipped_styles HEADER render/style/shipped_styles.h FILES ${POMONA_STYLES})
# Makes the text files part of the program: ${shipped_styles} names a source that defines the function of that name.
function(pomona_embed name)
  cmake_parse_arguments(ARG "" "HEADER" "FILES" ${ARGN})
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${ARG_FILES}" -DHEADER=${ARG_HEADER} -DFUNCTION=${name} -P ${script}
    DEPENDS ${ARG_FILES} ${script}
    VERBATIM)
  set(${name} ${output} PARENT_SCOPE)
endfunction()
