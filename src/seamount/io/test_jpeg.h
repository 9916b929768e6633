// A JPEG of a picture, for tests of readers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/image_file.h"
#include "seamount/io/test_files.h"

namespace seamount::io {

inline std::vector<uint8_t> encode_jpeg(const Image& image, int quality) {
  const TestFolder folder;
  const std::string path = folder("picture.jpg");
  const GdalCall call(path);
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  const DatasetPtr dataset(memory->Create("", image.width, image.height, 3, GDT_Byte, nullptr));
  std::vector<uint8_t> rgb = image.rgb;
  if (dataset->RasterIO(GF_Write, 0, 0, image.width, image.height, rgb.data(), image.width, image.height, GDT_Byte, 3,
                        nullptr, 3, 3 * image.width, 1, nullptr) != CE_None)
    call.fail("cannot be made");
  CPLStringList how;
  how.SetNameValue("QUALITY", std::to_string(quality).c_str());
  GDALDriver* jpeg = GetGDALDriverManager()->GetDriverByName("JPEG");
  DatasetPtr(jpeg->CreateCopy(path.c_str(), dataset.get(), FALSE, how.List(), nullptr, nullptr)).reset();
  return read_file(path);
}

}  // namespace seamount::io
