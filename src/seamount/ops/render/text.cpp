#include "seamount/ops/render/text.h"

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "seamount/base/error.h"
#include "seamount/ops/render/canvas.h"

namespace seamount::render {
namespace {

constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr uint32_t kReplacement = 0xfffd;

/// Takes one code point from the front of UTF-8 text; wrong bytes give the replacement character, one at a time.
uint32_t take_code_point(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const int length = first < 0x80 ? 1 : (first >> 5) == 6 ? 2 : (first >> 4) == 14 ? 3 : (first >> 3) == 30 ? 4 : 0;
  if (length == 1) {
    text.remove_prefix(1);
    return first;
  }
  if (length == 0 || text.size() < static_cast<size_t>(length)) {
    text.remove_prefix(1);
    return kReplacement;
  }
  uint32_t code = first & (0xffU >> (length + 1));
  for (int i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[static_cast<size_t>(i)]);
    if ((next >> 6) != 2) {
      text.remove_prefix(1);
      return kReplacement;
    }
    code = (code << 6) | (next & 0x3fU);
  }
  text.remove_prefix(static_cast<size_t>(length));
  return code;
}

}  // namespace

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  /// Calls visit(pen) with the glyph loaded and the pen in pixels from the start; returns the advance of the text.
  template <class Visitor>
  double walk(std::string_view text, double size_px, Visitor&& visit) const {
    FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(std::lround(size_px * 64.0)), 72, 72);
    double pen = 0.0;
    FT_UInt previous = 0;
    while (!text.empty()) {
      const FT_UInt glyph = FT_Get_Char_Index(face, take_code_point(text));
      if (previous != 0) {
        FT_Vector kerning{};
        FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kerning);
        pen += static_cast<double>(kerning.x) / 64.0;
      }
      if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING) != 0) continue;
      visit(pen);
      pen += static_cast<double>(face->glyph->linearHoriAdvance) / 65536.0;
      previous = glyph;
    }
    return pen;
  }
};

Font::Font() : face_(std::make_unique<Face>()) {
  if (FT_Init_FreeType(&face_->library) != 0) throw Error("text: FreeType does not start");
  if (FT_New_Face(face_->library, kFontFile, 0, &face_->face) != 0) {
    throw Error(std::string("text: cannot read ") + kFontFile + "; install the package fonts-dejavu-core");
  }
}

Font::~Font() = default;

double Font::width(std::string_view text, double size_px) const {
  return face_->walk(text, size_px, [](double) {});
}

void Font::draw(Image& image, double x, double y, double size_px, std::string_view text, Colour colour,
                Anchor anchor) const {
  if (anchor != Anchor::left) x -= width(text, size_px) * (anchor == Anchor::middle ? 0.5 : 1.0);
  write(image, {x, y}, {1.0, 0.0}, size_px, text, colour);
}

void Font::draw_along(Image& image, Vec2 middle, Vec2 along, double size_px, std::string_view text,
                      Colour colour) const {
  constexpr double kHalfDigit = 0.36;
  const Vec2 down{-along.y, along.x};
  const Vec2 start = middle - (0.5 * width(text, size_px)) * along + (kHalfDigit * size_px) * down;
  write(image, start, along, size_px, text, colour);
}

void Font::write(Image& image, Vec2 start, Vec2 along, double size_px, std::string_view text, Colour colour) const {
  const auto fixed = [](double value) { return static_cast<FT_Fixed>(std::lround(value * 65536.0)); };
  const FT_Matrix turn{fixed(along.x), fixed(along.y), fixed(-along.y), fixed(along.x)};
  face_->walk(text, size_px, [&](double pen) {
    // Glyphs start at fractions of a pixel: the outline is moved before it is drawn.
    const Vec2 at = start + pen * along;
    const double whole_x = std::floor(at.x), whole_y = std::floor(at.y);
    FT_GlyphSlot slot = face_->face->glyph;
    if (!(along == Vec2{1.0, 0.0})) FT_Outline_Transform(&slot->outline, &turn);
    FT_Outline_Translate(&slot->outline, static_cast<FT_Pos>((at.x - whole_x) * 64.0),
                         static_cast<FT_Pos>((whole_y - at.y) * 64.0));
    if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return;
    const FT_Bitmap& bitmap = slot->bitmap;
    for (unsigned row = 0; row < bitmap.rows; ++row) {
      for (unsigned column = 0; column < bitmap.width; ++column) {
        const int px = static_cast<int>(whole_x) + slot->bitmap_left + static_cast<int>(column);
        const int py = static_cast<int>(whole_y) - slot->bitmap_top + static_cast<int>(row);
        const unsigned char coverage = bitmap.buffer[static_cast<int>(row) * bitmap.pitch + static_cast<int>(column)];
        blend(image, px, py, colour, static_cast<float>(coverage) / 255.0F);
      }
    }
  });
}

}  // namespace seamount::render
