// Rasters that ranks write side by side, each of them one; then they are moved to where rank 0 writes the outputs.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "seamount/io/private_folder.h"
#include "seamount/recipe/recipe.h"
#include "seamount/tiles/ranks.h"

namespace seamount::tiles {

class SpreadOutputs {
 public:
  using Write = std::function<void(const recipe::Output& output, const std::string& path, const RunContext& own)>;

  /// Calls `write` for all of `outputs`, spread over the ranks, for files in a folder inside `parent`, which must be
  /// there. What it throws has the name that the file will have in `out_folder`. Every rank calls it.
  SpreadOutputs(Ranks& ranks, const std::string& parent, const std::string& out_folder,
                const std::vector<const recipe::Output*>& outputs, const Write& write, const RunContext& run);

  /// Moves an output's file to `path`. False: it was none of them. Throws WriteError.
  bool move_to(const recipe::Output& output, const std::string& path) const;
  /// What writing it took; 0 if it was none of them. At rank 0.
  double seconds(const recipe::Output& output) const;

 private:
  std::optional<io::PrivateFolder> folder_;  ///< rank 0's
  std::map<const recipe::Output*, std::string> files_;
  std::map<const recipe::Output*, double> seconds_;
};

}  // namespace seamount::tiles
