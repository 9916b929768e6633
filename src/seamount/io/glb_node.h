// Where the nodes of a glTF file put their meshes. Not part of the public interface.
#pragma once

#include <array>
#include <nlohmann/json.hpp>

namespace seamount::io {

using Matrix4 = std::array<double, 16>;  ///< columns, as glTF has them

constexpr Matrix4 kIdentityMatrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix4 product(const Matrix4& a, const Matrix4& b);

/// A node's matrix, or that of its translation, rotation and scale. Throws nlohmann::json::exception.
Matrix4 matrix_of(const nlohmann::json& node);

/// Of a translation, a rotation (x, y, z, w) and a scale.
Matrix4 matrix_of(const std::array<double, 3>& t, const std::array<double, 4>& rotation,
                  const std::array<double, 3>& s);

}  // namespace seamount::io
