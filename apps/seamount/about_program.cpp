#include "about_program.h"

#include "seamount/base/installation.h"
#include "seamount/base/printable.h"
#include "seamount/base/version.h"
#include "seamount/ops/learned/convolver.h"
#include "seamount/train/training.h"

namespace seamount::app {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "clang " __clang_version__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

std::string folder_of(Shared kind) {
  const std::string folder = find_shared_folder(kind);
  return folder.empty() ? "not found" : printable(folder);
}

}  // namespace

std::string about_program() {
  return std::string("seamount ") + kVersion + "\nbuilt by  " + kCompiler + "\nnetworks  " +
         (learned::has_bf16() ? "bf16 and f32" : "f32: this processor has no bf16") + "\ntraining  " +
         (train::can_train() ? "with libtorch" : "not installed") + "\nmodels    " + folder_of(Shared::models) +
         "\nrecipes   " + folder_of(Shared::recipes) + "\ndata      " + folder_of(Shared::data) + "\nstudio    " +
         folder_of(Shared::studio);
}

}  // namespace seamount::app
