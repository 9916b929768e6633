// libtorch takes half a second to load and most never train: the loop is a library of its own, loaded when it is asked
// for.
#include "seamount/train/training.h"

#include "seamount/base/error.h"
#include "seamount/base/shared_library.h"

namespace seamount::train {
namespace {

constexpr const char* kLibrary = "seamount_training.so";

}  // namespace

bool can_train() { return find_part(kLibrary).has_value(); }

Check train_network(const Task& task, const TrainingParams& params, const TrainingFiles& files, Seed seed,
                    const std::function<void(const std::string&)>& say, const RunContext& run) {
  check_params(params);
  const std::optional<std::string> library = find_part(kLibrary);
  if (!library) {
    throw Error(
        "this program was built without libtorch, which training needs: install libtorch-dev and libopenblas0-pthread, "
        "configure and build again");
  }
  using Loop = decltype(&train_network);
  return reinterpret_cast<Loop>(load_function(*library, "seamount_train_network"))(task, params, files, seed, say, run);
}

}  // namespace seamount::train
