#include <gtest/gtest.h>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/geom/grid/test_pictures.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/recipe/kind.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

/// JPEG halves the resolution of hue and rings at edges.
TEST(LabelPicture, SurvivesJpeg) {
  for (const auto& order : {geom::kInOrder, geom::kTraps, geom::kMoreTraps}) {
    const LabelMap truth = geom::island(256, order);
    const Image picture = geom::antialiased(256, order, 0.2);
    for (const int quality : {90, 60, 30}) {
      const geom::PaintedLabels painted =
          geom::decode_labels(io::read_image(io::encode_jpeg(picture, quality), "picture.jpg"), truth.frame(), {});
      const geom::Errors wrong = geom::errors(painted.labels, truth);
      EXPECT_LE(wrong.inside, 0.0002) << quality;
      EXPECT_LE(wrong.invented, 0.0002) << quality;
      EXPECT_LE(wrong.all, 0.008) << quality;
      EXPECT_NEAR(painted.subsidence, 0.2, 0.02);
    }
  }
}

LabelMap read_labels(const std::string& path, const GridFrame& frame) {
  const RunContext run;
  return *std::static_pointer_cast<const LabelMap>(kinds::Labels::kind().read_file({path, frame, false, run}));
}

TEST(LabelPicture, WrittenLabelsComeBackWhereTheyWere) {
  const io::TestFolder folder;
  const LabelMap labels = geom::island(24, geom::kInOrder);
  for (const std::string extension : {".png", ".tif"}) {
    const std::string path = folder("labels" + extension);
    io::write_labels(labels, path);
    EXPECT_EQ(read_labels(path, GridFrame::centred(7, 7, 1)), labels) << extension;
  }
  const std::string plain = folder("plain.png");
  io::write_png(geom::encode_labels(labels), plain);
  EXPECT_EQ(read_labels(plain, labels.frame()), labels) << "laid over the domain";
}

}  // namespace
}  // namespace seamount::recipe
