#include "seamount/io/splat.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/model/same_size.h"

namespace seamount::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kLayersOfColour = 3;

std::string stem_of(const std::string& path) { return path.substr(0, path.size() - extension_of(path).size()); }

/// Shares of 255 by the method of largest remainders: each within one of its true share, the sum exact.
void quantise(std::span<const double> weights, std::span<uint8_t> shares) {
  double total = 0;
  for (const double weight : weights) total += weight;
  std::fill(shares.begin(), shares.end(), uint8_t{0});
  if (!(total > 0)) {
    shares[0] = 255;
    return;
  }
  int left = 255;
  for (size_t i = 0; i < weights.size(); ++i) {
    shares[i] = static_cast<uint8_t>(255.0 * weights[i] / total);
    left -= shares[i];
  }
  for (; left > 0; --left) {
    size_t neediest = 0;
    double most = -1;
    for (size_t i = 0; i < weights.size(); ++i) {
      const double missing = 255.0 * weights[i] / total - shares[i];
      if (missing > most) most = missing, neediest = i;
    }
    ++shares[neediest];
  }
}

/// Layers in 8 bits: shares[m] of cell i are at m + layers * i.
std::vector<uint8_t> shares_of(std::span<const GroundLayer> layers) {
  const size_t cells = layers[0].weights.size();
  std::vector<uint8_t> shares(cells * layers.size());
  std::vector<double> weights(layers.size());
  for (size_t i = 0; i < cells; ++i) {
    for (size_t m = 0; m < layers.size(); ++m) {
      weights[m] = layers[m].weights.cells()[i];
      if (!(weights[m] >= 0) || !std::isfinite(weights[m]))
        throw InvalidArgument("weights", "must be finite and at least 0");
    }
    quantise(weights, std::span(shares).subspan(i * layers.size(), layers.size()));
  }
  return shares;
}

/// Samples of one file: its layers from `first` on, one as grey, else three as RGB with opaque alpha.
std::vector<uint8_t> samples_of(std::span<const uint8_t> shares, size_t layers, size_t first, bool grey) {
  const size_t cells = shares.size() / layers, channels = grey ? 1 : 4;
  std::vector<uint8_t> samples(cells * channels, 0);
  for (size_t i = 0; i < cells; ++i) {
    for (size_t c = 0; c < (grey ? 1 : kLayersOfColour) && first + c < layers; ++c)
      samples[i * channels + c] = shares[i * layers + first + c];
    if (!grey) samples[i * channels + 3] = 255;
  }
  return samples;
}

/// The mean share of a layer, of all cells or of those above the sea.
double mean_share(const GroundLayer& layer, const HeightField* ground) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < layer.weights.size(); ++i) {
    if (ground != nullptr && !(ground->cells()[i] >= 0)) continue;
    sum += layer.weights.cells()[i];
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double tenth_of_percent(double share) { return std::round(1000 * share) / 10; }

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

void write_list(std::span<const GroundLayer> layers, const std::vector<std::string>& files, const std::string& path,
                const SplatOptions& options) {
  static constexpr std::array<const char*, kLayersOfColour> kChannels = {"red", "green", "blue"};
  const GridFrame& frame = layers[0].weights.frame();
  Json json = {{"seamount", "splat"},      {"width", frame.width},      {"height", frame.height},
               {"cell_m", frame.cell_m},   {"west_m", frame.west_m},    {"north_m", frame.north_m},
               {"east_m", frame.east_m()}, {"south_m", frame.south_m()}};
  if (!frame.crs.empty()) json["crs"] = frame.crs;
  json["first_row"] = "north";
  json["layers"] = Json::array();
  const bool grey = options.files == SplatFiles::grey;
  for (size_t m = 0; m < layers.size(); ++m) {
    Json row = {{"name", layers[m].name},
                {"file", file_name(files[grey ? m : m / kLayersOfColour])},
                {"channel", grey ? "grey" : kChannels[m % kLayersOfColour]},
                {"percent", tenth_of_percent(mean_share(layers[m], nullptr))}};
    if (options.ground != nullptr) row["percent_of_land"] = tenth_of_percent(mean_share(layers[m], options.ground));
    json["layers"].push_back(row);
  }
  if (!options.provenance.program.empty()) json["made_by"] = options.provenance.program;
  write_text(splat_list(path), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void tell(std::span<const GroundLayer> layers, const std::string& path, const HeightField* ground,
          const RunContext& run) {
  std::string list;
  for (const GroundLayer& layer : layers) {
    const std::string percent = format_number(tenth_of_percent(mean_share(layer, ground)));
    list += (list.empty() ? "" : ", ") + layer.name + " " + percent + " %";
  }
  run.say((ground != nullptr ? "layers of the land: " : "layers: ") + list + "; " + file_name(splat_list(path)) +
          " names their files");
}

}  // namespace

std::string splat_list(const std::string& path) { return stem_of(path) + "_splat.json"; }

std::vector<std::string> splat_files(std::span<const std::string> layers, const std::string& path, SplatFiles files) {
  std::vector<std::string> all;
  const std::string stem = stem_of(path), extension = extension_of(path);
  if (files == SplatFiles::grey) {
    for (const std::string& layer : layers) all.push_back(stem + "_" + layer + extension);
  } else if (layers.size() <= kLayersOfColour) {
    all.push_back(path);
  } else {
    for (size_t i = 0; i * kLayersOfColour < layers.size(); ++i)
      all.push_back(stem + "_" + std::to_string(i) + extension);
  }
  all.push_back(splat_list(path));
  return all;
}

void write_splat(std::span<const GroundLayer> layers, const std::string& path, const SplatOptions& options,
                 const RunContext& run) {
  if (layers.empty() || layers[0].weights.empty()) throw InvalidArgument("weights", "there are none");
  const GridFrame& frame = layers[0].weights.frame();
  std::vector<std::string> names;
  for (const GroundLayer& layer : layers) {
    check_same_size("weights", layer.weights.frame(), frame, "first mask");
    names.push_back(layer.name);
  }
  if (options.ground != nullptr) check_same_size("ground", options.ground->frame(), frame, "first mask");
  if (extension_of(path) != ".png") throw IoError(path, "splat maps are PNG files");
  const bool grey = options.files == SplatFiles::grey;
  const std::vector<std::string> files = splat_files(names, path, options.files);
  const std::vector<uint8_t> shares = shares_of(layers);
  for (size_t file = 0; file + 1 < files.size(); ++file) {
    run.check_cancelled();
    const size_t first = grey ? file : kLayersOfColour * file;
    write_bytes(files[file],
                encode_png8(samples_of(shares, layers.size(), first, grey), frame.width, frame.height, grey ? 1 : 4));
  }
  write_list(layers, files, path, options);
  tell(layers, path, options.ground, run);
}

}  // namespace seamount::io
