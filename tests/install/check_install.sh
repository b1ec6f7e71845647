#!/usr/bin/env bash
# Installs a build to a temporary folder, builds programs against it by find_package and by
# pkg-config, runs them and the installed program, and makes the Debian packages.
#   check_install.sh BUILD SOURCE      says "install: all is well" where it is
set -euo pipefail
build=$1
source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/prefix
example=$source/examples/peaks_and_cam.cpp
own_solver=$source/examples/own_solver.cpp

fail() {
  echo "install: $*" >&2
  exit 1
}

# Runs a step and shows what it says only where it fails.
step() {
  "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; fail "failed: $*"; }
}

step cmake --install "$build" --prefix "$prefix"
for file in bin/camlaw share/man/man1/camlaw.1 share/bash-completion/completions/camlaw \
  share/zsh/site-functions/_camlaw share/zsh/vendor-completions/_camlaw \
  share/fish/vendor_completions.d/camlaw.fish \
  libexec/camlaw/camlaw-worker share/doc/camlaw/copyright; do
  [ -s "$prefix/$file" ] || fail "no $file"
done
(cd / && "$prefix/bin/camlaw" law cubic | grep '^cubic') >/dev/null || fail "the installed program fails"

# The problem files come along, and a copy of one needs nothing else.
(cd / && "$prefix/bin/camlaw" examples --json | grep "\"file\": \"$prefix/share/camlaw/problems/cams/") >/dev/null ||
  fail "the installed program does not find its problem files"
step "$prefix/bin/camlaw" examples cams/roller_from_catalogue --out "$folder/copy"
step "$prefix/bin/camlaw" check "$folder/copy/roller_from_catalogue.toml"
[ -z "$(find "$prefix/share/camlaw" -name '*.cpp')" ] || fail "sources among the problem files"

# find_package: kinematics alone, then all, with every header that is installed.
step cmake -S "$source/tests/install/project" -B "$folder/project" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_PREFIX_PATH="$prefix" -DEXAMPLE="$example" -DOWN_SOLVER="$own_solver" -DCMAKE_CXX_FLAGS="${CXXFLAGS:-}"
step cmake --build "$folder/project"
"$folder/project/laws" | grep ' is 2$' >/dev/null || fail "the part kinematics alone"
"$folder/project/example" | grep '^C_a is proved' >/dev/null || fail "the example does not run"
"$folder/project/own_solver" | grep 'by compass: certified' >/dev/null || fail "a solver of one's own"
radius=$("$folder/project/design" "$source/problems/spine_cutter/least_radius.toml")
[ "$radius" = 33.08 ] || fail "least radius: $radius, not 33.08"

"$folder/project/parts" "$source/problems/spine_cutter/least_radius.toml" || fail "a part of the library fails"

# pkg-config, also from a prefix that was moved.
mv "$prefix" "$folder/moved"
PKG_CONFIG_PATH=$(dirname "$(find "$folder/moved" -name camlaw.pc)")
export PKG_CONFIG_PATH
read -ra flags <<<"$(pkg-config --cflags camlaw)"
read -ra libraries <<<"$(pkg-config --libs camlaw)"
read -ra more <<<"${CXXFLAGS:-}"
step c++ -std=c++20 "${more[@]}" "${flags[@]}" "$example" -o "$folder/by_pkg_config" \
  "${libraries[@]}"
"$folder/by_pkg_config" | cmp - <("$folder/project/example") || fail "pkg-config: other output"
step c++ -std=c++20 "${more[@]}" "${flags[@]}" "$source/tests/install/project/design.cpp" \
  -o "$folder/design" "${libraries[@]}"

if command -v dpkg-shlibdeps >/dev/null; then
  (cd "$build" && step cpack -G DEB -B "$folder/packages")
  program=$(echo "$folder"/packages/camlaw_*.deb)
  development=$(echo "$folder"/packages/libcamlaw-dev_*.deb)
  dpkg-deb -I "$program" | grep 'Depends:.*libnlopt' >/dev/null || fail "the package lacks dependencies"
  dpkg-deb -c "$program" | grep '\./usr/bin/camlaw$' >/dev/null || fail "the package lacks the program"
  dpkg-deb -I "$program" | grep 'Depends:.*libopenmpi' >/dev/null && fail "the program's package needs MPI"
  dpkg-deb -I "$development" | grep 'Depends:.*libeigen3-dev' >/dev/null || fail "libcamlaw-dev: depends"
  dpkg-deb -c "$development" | grep 'camlawConfig\.cmake$' >/dev/null || fail "libcamlaw-dev: no config"
fi
echo "install: all is well"
