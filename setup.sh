#!/usr/bin/env bash
# Brings a Debian 12 machine to the point where a CMake preset is built: packages, configuration, build.
#   ./setup.sh PRESET      PRESET is one of CMakePresets.json: release, dev, asan
# Does nothing that is already done, and needs the network only while packages are missing.
set -euo pipefail
cd "$(dirname "$0")"
preset=${1:?usage: setup.sh PRESET}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; elif command -v sudo >/dev/null; then sudo "$@"; else
    echo "setup.sh: installing packages needs root or sudo: $*" >&2
    exit 1
  fi
}

install_packages() {
  local wanted installed missing
  wanted=$(grep -v '^#' packages.txt | sort)
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null |
    sed -n 's/^installed //p' | sort -u)
  missing=$(comm -23 <(echo "$wanted") <(echo "$installed"))
  [ -z "$missing" ] && return
  echo "setup.sh: installing" $missing >&2
  as_root apt-get update -qq >&2
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing >&2
}

install_packages
[ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >&2
# Ninja's own chatter goes to a log; on failure it is shown.
mkdir -p build
if ! cmake --build --preset "$preset" >"build/$preset.log" 2>&1; then
  cat "build/$preset.log" >&2
  exit 1
fi
