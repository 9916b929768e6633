// A current over a map: arrows whose length is its speed.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/image.h"
#include "seamount/model/vector_field.h"
#include "seamount/ops/render/map_furniture.h"

namespace seamount::render {

/// How arrows are drawn: as long as the spacing where the speed is `full_m_s` or more.
struct ArrowScale {
  double spacing_px = 40.0;
  double full_m_s = 1.0;  ///< a round number that a twentieth of the arrows reaches, about
};

/// REQUIRES: a current without unknown cells.
ArrowScale arrow_scale(const VectorField& current, double spacing_px);

/// Draws arrows into the box of the picture that the current is shown in, in rows that are shifted against each other,
/// each for the mean of the current around it. None where it is slower than a twentieth of full_m_s.
void draw_arrows(Image& image, const Box& box, const VectorField& current, const ArrowScale& scale, double unit,
                 const RunContext& run);

/// The arrow of full_m_s with its speed, ending at (right, y).
void draw_arrow_key(Image& image, const Font& font, double right, double y, const ArrowScale& scale, double unit);

}  // namespace seamount::render
