// Text in pictures: DejaVu Sans by FreeType, anti-aliased, without hinting so that any size looks the same everywhere.
#pragma once

#include <memory>
#include <string_view>

#include "seamount/model/drawn.h"
#include "seamount/model/image.h"

namespace seamount::render {

/// Where text stands against its anchor point (on the baseline).
enum class Anchor { left, middle, right };

class Font {
 public:
  /// Throws Error, naming the package to install, where the system has no DejaVu Sans.
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Width in pixels of UTF-8 text at `size_px` pixels an em. Bytes that are not UTF-8 show as a replacement character.
  double width(std::string_view text, double size_px) const;

  /// Writes text with its baseline at (x, y); what leaves the picture is cut off. Linear in the pixels it covers.
  void draw(Image& image, double x, double y, double size_px, std::string_view text, Colour colour,
            Anchor anchor = Anchor::left) const;

  /// The same with its middle, half way up the digits, at a place, along a unit vector (y down, as pixels go).
  void draw_along(Image& image, Vec2 middle, Vec2 along, double size_px, std::string_view text, Colour colour) const;

 private:
  void write(Image& image, Vec2 start, Vec2 along, double size_px, std::string_view text, Colour colour) const;

  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace seamount::render
