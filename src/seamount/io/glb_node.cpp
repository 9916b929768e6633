#include "seamount/io/glb_node.h"

namespace seamount::io {

Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 c{};
  for (size_t column = 0; column < 4; ++column)
    for (size_t row = 0; row < 4; ++row)
      for (size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return c;
}

Matrix4 matrix_of(const nlohmann::json& node) {
  if (node.contains("matrix")) return node.at("matrix").get<Matrix4>();
  return matrix_of(node.value("translation", std::array<double, 3>{0, 0, 0}),
                   node.value("rotation", std::array<double, 4>{0, 0, 0, 1}),
                   node.value("scale", std::array<double, 3>{1, 1, 1}));
}

Matrix4 matrix_of(const std::array<double, 3>& t, const std::array<double, 4>& rotation,
                  const std::array<double, 3>& s) {
  const auto [x, y, z, w] = rotation;
  return {(1 - 2 * (y * y + z * z)) * s[0],
          2 * (x * y + z * w) * s[0],
          2 * (x * z - y * w) * s[0],
          0,
          2 * (x * y - z * w) * s[1],
          (1 - 2 * (x * x + z * z)) * s[1],
          2 * (y * z + x * w) * s[1],
          0,
          2 * (x * z + y * w) * s[2],
          2 * (y * z - x * w) * s[2],
          (1 - 2 * (x * x + y * y)) * s[2],
          0,
          t[0],
          t[1],
          t[2],
          1};
}

}  // namespace seamount::io
