# What ./run and ./test share: packages, configuring, building. Everything said here goes to stderr.

say() { printf '%s\n' "$*" >&2; }

# packages_for PURPOSE...: what packages/PURPOSE.txt lists.
packages_for() {
  local purpose
  for purpose; do sed '/^#/d' "packages/$purpose.txt"; done
}

missing_packages() {
  LC_ALL=C comm -23 <(packages_for "$@" | LC_ALL=C sort) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' | sed -n 's/^installed //p' | tr ',' '\n' |
      sed -E 's/^ +//; s/ .*//' | LC_ALL=C sort -u)
}

# install_packages PURPOSE...: instant when nothing is missing. Elsewhere than on Debian packages are the user's business.
install_packages() {
  local missing as_root=()
  command -v dpkg-query >/dev/null || { say "seamount: not Debian; packages/*.txt list what must be installed"; return 0; }
  missing=$(missing_packages "$@")
  [[ $missing ]] || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || { say "seamount: needs root or sudo to install:" $missing; return 1; }
    as_root=(sudo)
  fi
  say "seamount: installing" $missing
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update >&2 && "${apt[@]}" install -y --no-install-recommends $missing >&2 </dev/null
}

# configure PRESET [CMAKE_ARGS]: when that was never done, the presets changed, or the build folder has other settings.
configure() {
  local preset=$1 setting stale=
  shift
  [[ build/$preset/build.ninja -nt CMakePresets.json ]] || stale=1
  for setting; do
    grep -qsxF "${setting#-D}" "build/$preset/CMakeCache.txt" || stale=1
  done
  [[ ! $stale ]] || cmake --preset "$preset" "$@" >&2
}

# build PRESET TARGET...: silent when all is built.
build() {
  local preset=$1
  shift
  (set -o pipefail && cd "build/$preset" && ninja "$@" | sed -uE '/no work to do|Re-checking globbed/d' >&2)
}
