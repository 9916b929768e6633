#include "seamount/recipe/dictionary_file.h"

#include "seamount/base/error.h"
#include "seamount/io/weights.h"

namespace seamount::recipe {

amplify::Dictionary read_dictionary(const std::string& path) {
  const Weights weights = io::read_weights(path);
  try {
    return amplify::dictionary_of(weights);
  } catch (const Error& error) {
    throw IoError(path, error.what());
  }
}

}  // namespace seamount::recipe
