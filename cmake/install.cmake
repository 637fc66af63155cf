# What `cmake --install` and `make package` put where.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(data ${CMAKE_INSTALL_DATADIR}/pomona)

# ---- The program: what it needs beside it, its manual page, what shells complete, documents ----
# Each goes with the component "program", which is all of the Debian package.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS pomona RUNTIME)
install(DIRECTORY templates scenes styles DESTINATION ${data} PATTERN "*.py" EXCLUDE)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs
  FILES_MATCHING PATTERN "*.md" PATTERN "*.yaml" PATTERN pictures EXCLUDE PATTERN figures EXCLUDE)
# What programs need that cut assets (docs/reference/asset.md).
set(asset_files read_asset.js look_up.js look.glsl engines/three_cut.mjs engines/three.html engines/package.json)
list(TRANSFORM asset_files PREPEND render/page/)
install(FILES ${asset_files} DESTINATION ${data}/asset)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

# The look-up in other languages, translated; made with the pages below.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(look_ups look.hlsl look.wgsl look.gdshaderinc)
list(TRANSFORM look_ups PREPEND ${PROJECT_BINARY_DIR}/look_ups/)
add_custom_command(OUTPUT ${look_ups}
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/render/page/engines/translate_look.py ${PROJECT_BINARY_DIR}/look_ups
  DEPENDS render/page/look.glsl render/page/engines/translate_look.py VERBATIM)
install(FILES ${look_ups} DESTINATION ${data}/asset)

# pomona_page(bash share/bash-completion/completions pomona): what `pomona pages bash` prints, under that name.
set(pages)
function(pomona_page kind folder name)
  set(page ${PROJECT_BINARY_DIR}/pages/${name})
  add_custom_command(OUTPUT ${page}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/pages
    COMMAND pomona pages ${kind} > ${page}
    DEPENDS pomona VERBATIM)
  install(FILES ${page} DESTINATION ${folder})
  set(pages ${pages} ${page} PARENT_SCOPE)
endfunction()
pomona_page(man ${CMAKE_INSTALL_MANDIR}/man1 pomona.1)
pomona_page(bash ${CMAKE_INSTALL_DATADIR}/bash-completion/completions pomona)
pomona_page(zsh ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions _pomona)
pomona_page(fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d pomona.fish)
add_custom_target(pages ALL DEPENDS ${pages} ${look_ups})

# ---- The library: one archive of all folders, the public headers, and how CMake finds them ----
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
include(cmake/dependencies.cmake)
get_property(libraries GLOBAL PROPERTY POMONA_LIBRARIES)
set(objects)
foreach(library ${libraries})
  list(APPEND objects $<TARGET_OBJECTS:${library}>)
endforeach()
add_library(pomona_archive STATIC ${objects})
set_target_properties(pomona_archive PROPERTIES OUTPUT_NAME pomona EXPORT_NAME pomona LINKER_LANGUAGE CXX)
target_compile_features(pomona_archive INTERFACE cxx_std_20)
target_include_directories(pomona_archive INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pomona>)
target_link_libraries(pomona_archive PUBLIC glm::glm PRIVATE PkgConfig::POMONA_NEEDS meshoptimizer::meshoptimizer ${CMAKE_DL_LIBS})

# The steps of docs/guides/library.md; what these include is installed with them.
set(POMONA_PUBLIC_HEADERS
  # templates, variants, surfaces
  generator/template/read/read_template.h generator/compose/grow.h generator/surface/file/surface_file.h
  # knives and pieces
  generator/knife/parse_knife.h generator/cut/cut.h generator/cut/section/section_file.h generator/piece/slice.h
  generator/piece/piece_facts.h
  # diffusers
  generator/diffusion/pmvc/pmvc_diffuser.h generator/diffusion/harmonic/harmonic_diffuser.h
  generator/diffusion/walk/walk_diffuser.h render/diffusion/gl_diffuser.h
  # orders, and the bytes of all files
  generator/order/option_table.h generator/order/ordered_fruit.h render/deliver/deliver.h render/deliver/live_files.h
  render/deliver/piece_files.h render/deliver/scene_page_files.h render/deliver/section_files.h
  # scenes
  generator/scene/compose.h generator/scene/explode.h generator/scene/lay_out.h generator/scene/layout_file.h
  generator/scene/scene_file.h
  # pictures and files
  render/gl/scene_picture.h render/truth/ground_truth.h render/image/png.h render/style/style_file.h render/picture/section_picture.h
  render/export/gltf/write_glb.h render/export/usd/write_usda.h render/export/obj.h render/export/stl.h render/export/output.h
  render/export/ply.h render/export/pov.h render/export/svg.h)

set(config ${CMAKE_INSTALL_LIBDIR}/cmake/Pomona)
install(TARGETS pomona_archive EXPORT PomonaTargets ARCHIVE)
install(EXPORT PomonaTargets NAMESPACE Pomona:: DESTINATION ${config})
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -DSOURCE=${PROJECT_SOURCE_DIR}
  -DDESTINATION=\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/pomona \"-DHEADERS=${POMONA_PUBLIC_HEADERS}\"
  -P ${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake COMMAND_ERROR_IS_FATAL ANY)")
configure_package_config_file(cmake/PomonaConfig.cmake.in ${PROJECT_BINARY_DIR}/PomonaConfig.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PomonaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PomonaConfig.cmake ${PROJECT_BINARY_DIR}/PomonaConfigVersion.cmake
  cmake/dependencies.cmake DESTINATION ${config})

# ---- The Debian package: the program ----
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME pomona)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGE_CONTACT "Pomona maintainers")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# OpenGL is looked for when the program runs: one that works anywhere, and the way to graphics cards.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libosmesa6)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri")
if(POMONA_PYTHON)
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", python3-numpy")
endif()
include(CPack)
