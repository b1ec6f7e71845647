#!/usr/bin/env bash
# Brings a Debian 12 machine to the point where a CMake preset is built: packages, configuration, build.
#   ./setup.sh PRESET [TARGET...]      PRESET is one of CMakePresets.json: release, dev, asan, ...
# Packages are those of packages.txt, of packages-PRESET.txt where there is one, and of packages-NAME.txt
# for each NAME in the environment variable CAMLAW_PACKAGES.
# Does nothing that is already done, and needs the network only while packages are missing.
set -euo pipefail
cd "$(dirname "$0")"
preset=${1:?usage: setup.sh PRESET [TARGET...]}
shift
build=build/$preset

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
  local wanted installed missing
  local lists=(packages.txt)
  local name
  for name in "$preset" ${CAMLAW_PACKAGES:-}; do
    [ -f "packages-$name.txt" ] && lists+=("packages-$name.txt")
  done
  wanted=$(cat "${lists[@]}" | grep -v '^#' | sort)
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null |
    sed -n 's/^installed //p' | sort -u)
  missing=$(comm -23 <(echo "$wanted") <(echo "$installed"))
  [ -z "$missing" ] && return
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    echo "setup.sh: installing packages needs root or sudo:" $missing >&2
    exit 1
  fi
  mkdir -p build
  local log=build/packages.log
  echo "setup.sh: installing $(wc -w <<<"$missing") packages and what they need (log: $log)" >&2
  printf '%s\n' $missing >"$log"
  # The status lines' descriptor is opened within, as sudo closes those of ours.
  if ! { as_root apt-get update -qq >>"$log" 2>&1 &&
    as_root sh -c 'DEBIAN_FRONTEND=noninteractive exec apt-get install -y -qq \
      --no-install-recommends -o APT::Status-Fd=3 "$@" 3>&1 >>"$0" 2>&1' "$log" $missing |
      show_share; }; then
    cat "$log" >&2
    exit 1
  fi
}

# Of apt's status lines, "pmstatus:PACKAGE:SHARE:WORDS", the share that is done, on one line.
show_share() {
  if [ -t 2 ]; then
    awk -F: '{ printf "\rsetup.sh: %3d %%", $3; fflush() } END { print "" }' >&2
  else
    cat >/dev/null
  fi
}

configure() {
  # A build folder that was made elsewhere, or for other presets, starts afresh.
  if [ -f "$build/CMakeCache.txt" ] &&
    { ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$build/CMakeCache.txt" ||
      { [ -f "$build/build.ninja" ] && [ CMakePresets.json -nt "$build/build.ninja" ]; }; }; then
    rm -rf "$build"
  fi
  if [ ! -f "$build/build.ninja" ]; then
    echo "setup.sh: building ($preset; some minutes the first time)" >&2
    cmake --preset "$preset" >&2
  fi
}

install_packages
mkdir -p build
exec 9>build/.lock
flock 9
configure
# Ninja's own chatter goes to a log; on failure it is shown.
if ! cmake --build --preset "$preset" ${1:+--target "$@"} >"$build.log" 2>&1; then
  cat "$build.log" >&2
  exit 1
fi
