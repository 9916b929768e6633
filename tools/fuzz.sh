#!/usr/bin/env bash
# tools/fuzz.sh SECONDS PROGRAM [SEED]: runs one libFuzzer target from its corpus. What it finds stays in build/fuzz: inputs
# that reach new code in NAME/, and any that crashes as NAME-crash-...: copy that to tests/fuzz/corpus/NAME, where every
# later test run replays it. With a seed the inputs are the same each time, so that a gate does not hang on chance.
set -euo pipefail
program=$(realpath "$2") name=$(basename "$2" _fuzz)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
corpora=("build/fuzz/$name" "tests/fuzz/corpus/$name")
log=build/fuzz/$name.log
mkdir -p "${corpora[0]}"
[[ -d ${corpora[1]} ]] || unset 'corpora[1]'
"$program" -seed="${3-0}" -max_total_time="$1" -timeout=20 -rss_limit_mb=2048 -artifact_prefix="build/fuzz/$name-" "${corpora[@]}" \
  &>"$log" || { tail -n 60 "$log"; exit 1; }
printf '%s: %s\n' "$name" "$(grep -o '^Done .*' "$log")"
