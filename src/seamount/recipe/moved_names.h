// The names of files in a document that goes to another folder.
#pragma once

#include <string>

#include "seamount/recipe/edit.h"

namespace seamount::recipe {

/// A document, or what an edit put at `pointer` of one, with the relative names of files in `from` as they are seen
/// from the folder `to`. A name is a text that leads to a file there; the outputs, whose paths begin elsewhere, the
/// identifiers of steps and remarks stay as they are. The same text becomes the same everywhere, so that a history goes
/// with its document.
OrderedJson seen_from(OrderedJson json, const std::string& pointer, const std::string& from, const std::string& to);

}  // namespace seamount::recipe
