// Samples for the sketch synthesizer from a set on disk (sketch_set.h), made by `dataset sketches` or drawn by hand.
//
// A sample is an example of the set, turned and mirrored, with kinds left out at random; larger examples are cut. What
// is drawn is drawn: strokes are neither thinned nor shifted, as those of SketchTask are.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/train/held_out.h"
#include "seamount/train/sample.h"
#include "seamount/train/sketch_set.h"

namespace seamount::train {

/// What a line of the manifest says of an example.
struct StoredSketch {
  uint64_t index = 0;
  std::string tile;
  SketchDraw draw;
};

class StoredSketchTask : public Task {
 public:
  /// `folder` holds the files of the examples, of `size` cells a side. Throws InvalidArgument{"--set"} for examples of
  /// less than 64 cells and where there are too few; training() and held_out() throw IoError for files that cannot be
  /// read or are of another size.
  StoredSketchTask(std::string folder, int size, std::vector<StoredSketch> examples, Seed seed);

  std::string name() const override { return "sketch"; }
  learned::Architecture architecture() const override;
  std::vector<int> drawn_planes() const override;
  Sample training(uint64_t n) const override { return sample(split_.learned, seed_.derive("training", n)); }
  Sample held_out(uint64_t n) const override { return sample(split_.held_out, seed_.derive("held out", n)); }

 private:
  Sample sample(const std::vector<size_t>& among, Seed seed) const;

  std::string folder_;
  int stored_size_, size_;
  std::vector<StoredSketch> examples_;
  Seed seed_;
  Split split_;
};

}  // namespace seamount::train
