// How careful the steps of a descent are (Levenberg 1944), and when it is over.
#pragma once

#include <algorithm>

namespace seamount::geom {

struct StepCare {
  double damping = 1.0;
  bool rests = false;

  /// `usual`: damping at which a step of the plain slope is about as long as it should be.
  void start(double usual) {
    usual_ = usual;
    damping = 0.1 * usual;
    small_gains_ = 0;
    rests = false;
  }

  void refuse() {
    damping *= 8.0;
    rests = damping > 1e7 * usual_;
  }

  void stop() { rests = true; }

  /// After three steps on end that gained less than least_gain there is rest.
  void accept(double gain, double least_gain) {
    small_gains_ = gain < least_gain ? small_gains_ + 1 : 0;
    rests = small_gains_ >= 3;
    damping = std::max(0.25 * damping, 1e-5 * usual_);
  }

 private:
  double usual_ = 1.0;
  int small_gains_ = 0;
};

}  // namespace seamount::geom
