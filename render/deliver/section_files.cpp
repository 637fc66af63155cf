#include "render/deliver/section_files.h"

#include <utility>

#include "generator/cut/section/section_file.h"
#include "render/deliver/outside_parts.h"
#include "render/export/svg.h"
#include "render/image/png.h"
#include "render/picture/section_picture.h"

namespace pomona {

Delivered section_files(const Slices& slices, const Template& fruit, const Order& order, const DeliverOptions& how) {
  const PictureSize size = picture_size(order.picture).value_or(how.usual_size);
  const SectionPictureOptions options{.width = size.width,
                                      .height = size.height,
                                      .dpi = order.picture.dpi,
                                      .text = {fruit.title, fruit.latin},
                                      .outside = outside_parts(fruit),
                                      .threads = order.threads};
  const Look look(fruit.noise, fruit.details);
  Delivered delivered;
  for (const Output& output : order.outputs) {
    if (output.format == Format::ply) {
      delivered.add(output.file, [&] { return write_section(slices.section); });
    } else if (output.format == Format::svg) {
      delivered.add(output.file, [&] {
        return write_section_svg(slices.styled, look, fruit.ink, how.style, options, made_by(how.provenance));
      });
    } else {
      Image image = delivered.times.time(
          "style", [&] { return draw_section(slices.styled, look, fruit.ink, how.style, options); });
      image.dpi = order.picture.dpi;
      if (how.take_picture) {
        how.take_picture(std::move(image));
        continue;
      }
      delivered.add(output.file, [&] { return write_png(image); });
    }
  }
  return delivered;
}

}  // namespace pomona
