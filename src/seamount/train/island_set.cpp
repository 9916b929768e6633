#include "seamount/train/island_set.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/folder_lock.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

namespace seamount::train {
namespace {

namespace fs = std::filesystem;

std::string file_of(const std::string& folder, uint64_t index, const char* what) {
  return (fs::path(folder) / fmt::format("{:06}_{}.png", index, what)).string();
}

/// Complete lines of a manifest; a last one without its end is a run that was killed while writing it.
std::vector<std::string> complete_lines(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line) && !file.eof();) lines.push_back(line);
  return lines;
}

class Manifest {
 public:
  Manifest(const std::string& folder, const std::string& header)
      : path_((fs::path(folder) / "manifest.jsonl").string()) {
    std::vector<std::string> lines = complete_lines(path_);
    if (!lines.empty() && lines.front() != header) {
      throw InvalidArgument("--out", folder + " holds a set with other parameters or another seed: " + lines.front());
    }
    if (lines.empty()) lines.push_back(header);
    finished_ = lines.size() - 1;
    io::write_atomically(path_, [&](const std::string& temporary) {
      std::ofstream file(temporary, std::ios::binary);
      for (const std::string& line : lines) file << line << "\n";
      if (!file.flush()) throw IoError(path_, "cannot be written");
    });
  }

  uint64_t finished() const { return finished_; }

  void append(const std::string& lines) {
    std::FILE* file = std::fopen(path_.c_str(), "ab");
    const bool written =
        file != nullptr && std::fwrite(lines.data(), 1, lines.size(), file) == lines.size() && std::fflush(file) == 0;
    const bool kept = written && fsync(fileno(file)) == 0;
    if (file != nullptr) std::fclose(file);
    if (!kept) throw IoError(path_, "cannot be written");
  }

 private:
  std::string path_;
  uint64_t finished_ = 0;
};

}  // namespace

void make_island_files(const IslandSetParams& params, IslandSample& sample, Seed seed, const std::string& folder,
                       const RunContext& run) {
  IslandPair pair = make_island_pair(params, sample, seed, run);
  for (float& z : pair.terrain.cells())
    z = std::clamp(z, static_cast<float>(params.low_m), static_cast<float>(params.high_m));
  io::write_png(geom::encode_labels(pair.labels, sample.subsidence), file_of(folder, sample.index, "labels"));
  io::write_heights(pair.terrain, file_of(folder, sample.index, "height"),
                    {.range = io::HeightRange{params.low_m, params.high_m}, .sidecar = false, .provenance = {}});
}

IslandSetReport make_island_set(const IslandSetParams& params, const IslandSetOptions& options, const RunContext& run) {
  check_params(params);
  const io::FolderLock lock(options.folder);
  Manifest manifest(options.folder, options.line(nullptr));
  IslandSetReport report;
  report.present = std::min(manifest.finished(), options.count);
  constexpr uint64_t kBatch = 32;  // lines are kept in order by writing them batch by batch
  for (uint64_t first = manifest.finished(); first < options.count; first += kBatch) {
    const uint64_t size = std::min(kBatch, options.count - first);
    std::vector<std::string> lines(size);
    RunContext each = run;
    each.progress = nullptr;
    parallel_blocks(each, static_cast<int64_t>(size), 1, [&](int64_t begin, int64_t) {
      IslandSample sample = draw_island_sample(params, first + static_cast<uint64_t>(begin), options.seed);
      RunContext one = each;
      one.threads = 1;
      make_island_files(params, sample, options.seed, options.folder, one);
      lines[static_cast<size_t>(begin)] = options.line(&sample);
    });
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    manifest.append(text);
    report.made += size;
    run.report(static_cast<double>(first + size) / static_cast<double>(options.count));
  }
  return report;
}

}  // namespace seamount::train
