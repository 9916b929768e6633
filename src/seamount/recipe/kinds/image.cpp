// image: a picture.
#include "seamount/io/image_file.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

void write_image(Writer& writer, const Image& image) {
  writer.plain(image.width);
  writer.plain(image.height);
  writer.list(image.rgb);
}

Image read_image(Reader& reader) {
  Image image;
  image.width = reader.plain<int>();
  image.height = reader.plain<int>();
  image.rgb = reader.list<uint8_t>();
  return image;
}

}  // namespace

const Kind& kinds::Image::kind() {
  static const Kind kind = make_kind<seamount::Image>({
      .name = "image",
      .about = "a picture",
      .files = {".png"},
      .reads = {".png", ".jpg", ".jpeg"},
      .frame = {},
      .bytes = [](const seamount::Image& image) { return image.rgb.size(); },
      .write = write_image,
      .read = read_image,
      .read_file = [](const FileCall& call) { return io::read_image(call.path); },
      .info = io::describe_picture,
  });
  return kind;
}

void kinds::Image::add_formats(Registry& registry) {
  registry.add(make_format<NoParams>(
      {"image", "a picture", io::picture_extensions(), io::picture_extensions(), {&kind()}},
      [](const NoParams&, const OutputCall& call) { io::write_picture(call.value.get<Image>(), call.path); }));
}

}  // namespace seamount::recipe
