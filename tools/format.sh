#!/usr/bin/env bash
# Formats every C++ file in place; with --check names what is not formatted, changes nothing and fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
action=(-i)
[[ ${1-} == --check ]] && action=(--dry-run -Werror)
find src apps bench tests examples \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -r -n 16 -P "$(nproc)" clang-format-14 "${action[@]}"
