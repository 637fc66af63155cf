# cmake -DOUTPUT=x.cpp "-DFILES=a.toml;b.toml" -DHEADER=render/style/shipped_styles.h -DFUNCTION=shipped_styles
#       -P embed_files.cmake
# Text files as string literals: a function that returns a span of EmbeddedFile.
set(text "// Made from files of the source tree; do not edit.\n#include \"${HEADER}\"\n\n")

# Letters are longer than the strings that every compiler must take, and than clang measures while it compiles.
string(APPEND text "#ifdef __clang__\n#pragma clang diagnostic ignored \"-Woverlength-strings\"\n#endif\n\n")
# Made when first asked for: others may ask before this source's own constants are.
string(APPEND text "namespace pomona {\n\nstd::span<const EmbeddedFile> ${FUNCTION}() {\n  static const EmbeddedFile files[] = {\n")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} source)
  string(APPEND text "    {\"${name}\", R\"text(${source})text\"},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace pomona\n")
file(WRITE ${OUTPUT} "${text}")
