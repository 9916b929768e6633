# What ./run and ./test share: packages, configuring, building. Everything said here goes to stderr.

say() { printf '%s\n' "$*" >&2; }

missing_packages() {
  LC_ALL=C comm -23 <(grep -v '^#' packages.txt | LC_ALL=C sort) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | LC_ALL=C sort)
}

# Instant when nothing is missing. Elsewhere than on Debian the packages are the user's business.
install_packages() {
  command -v dpkg-query >/dev/null || { say "seamount: not Debian; packages.txt lists what must be installed"; return 0; }
  local missing as_root=()
  missing=$(missing_packages)
  [[ $missing ]] || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || { say "seamount: needs root or sudo to install:" $missing; return 1; }
    as_root=(sudo)
  fi
  say "seamount: installing" $missing
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update >&2 && "${apt[@]}" install -y --no-install-recommends $missing >&2 </dev/null
}

# build PRESET TARGET...: configures when that was never done or the presets changed; silent when all is built.
build() {
  local preset=$1
  shift
  if [[ ! build/$preset/build.ninja -nt CMakePresets.json ]]; then
    cmake --preset "$preset" >&2 || return
  fi
  (set -o pipefail && cd "build/$preset" && ninja "$@" | sed -uE '/no work to do|Re-checking globbed/d' >&2)
}
