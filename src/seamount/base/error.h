// Errors of the library. Operators and readers throw one of these; they are caught in main, in the server's dispatcher
// and in the recipe executor (which adds the step). A message names the thing, the value and the rule: "subsidence: 1.5
// is outside [0, 1]".
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace seamount {

/// Base of everything that Seamount throws on purpose. what() is one line, fit to be shown to the user.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A parameter or argument breaks its rule. field() is its name as the user wrote it.
class InvalidArgument : public Error {
 public:
  InvalidArgument(std::string field, const std::string& problem)
      : Error(field + ": " + problem), field_(std::move(field)) {}
  const std::string& field() const { return field_; }

 private:
  std::string field_;
};

/// Inputs are fine one by one but not together: two rasters of different size, say.
class IncompatibleInputs : public Error {
 public:
  using Error::Error;
};

/// A file cannot be read, understood or written. path() is the file.
class IoError : public Error {
 public:
  IoError(std::string path, const std::string& problem) : Error(path + ": " + problem), path_(std::move(path)) {}
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A file cannot be written: the work failed, its input may be fine. path() is the file that was wanted.
class WriteError : public IoError {
 public:
  using IoError::IoError;
};

/// The user asked for the work to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace seamount
