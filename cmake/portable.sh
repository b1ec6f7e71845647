#!/usr/bin/env bash
# Makes a folder, and an archive of it, in which camlaw runs on any 64-bit Linux (x86-64): the program
# with every library that it is linked with, the C library and its dynamic linker too, so that nothing
# of the system is used but the kernel and /proc.
#   cmake/portable.sh BUILD [OUT]      by default OUT is BUILD; writes OUT/camlaw-VERSION-x86_64.tar.gz
# BUILD is a build of camlaw and camlaw_pages, such as build/release.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "${1:?usage: portable.sh BUILD [OUT]}" && pwd)
mkdir -p "${2:-$build}"
out=$(cd "${2:-$build}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=camlaw-$version-x86_64
prefix=$work/$name
cmake --install "$build" --prefix "$prefix" --component program --strip >"$work/log" || {
  cat "$work/log" >&2
  exit 1
}

# The real programs go to lib/camlaw; the launcher takes their places.
mkdir -p "$prefix/lib/camlaw"
mv "$prefix/bin/camlaw" "$prefix/libexec/camlaw/camlaw-worker" "$prefix/lib/camlaw"
cc -Os -Wall -Wextra -static -s "$source/cmake/launcher.c" -o "$prefix/bin/camlaw"
cp "$prefix/bin/camlaw" "$prefix/libexec/camlaw/camlaw-worker"

# The package that a file is of; Debian's lists have some libraries without /usr.
package_of() {
  local real
  real=$(readlink -f "$1")
  for path in "$real" "$1" "${real#/usr}"; do
    dpkg-query -S "$path" 2>/dev/null | head -n 1 | cut -d: -f1 | grep . && return
  done
  echo "portable.sh: no package is known for $1, so its licence is not among the others" >&2
}

# All libraries that programs and plug-ins ask for, by the names that they ask for, and what their
# packages say of copying them.
files=("$prefix"/lib/camlaw/* "$prefix"/libexec/camlaw/*.so)
ldd "${files[@]}" | awk '$2 == "=>" && $3 ~ /^\// { print $3 } $1 ~ /^\/.*ld-linux/ { print $1 }' | sort -u |
  while read -r library; do
    cp -L "$library" "$prefix/lib/"
    package=$(package_of "$library" || true)
    [ -f "/usr/share/doc/${package:-none}/copyright" ] || continue
    mkdir -p "$prefix/share/doc/$package"
    cp -L "/usr/share/doc/$package/copyright" "$prefix/share/doc/$package/"
  done
mkdir -p "$prefix/share/udunits" "$prefix/share/doc/camlaw"
cp -L /usr/share/xml/udunits/*.xml "$prefix/share/udunits/"
cp "$source/README.md" "$prefix/share/doc/camlaw/"

tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner -czf "$out/$name.tar.gz" "$name"
echo "wrote $out/$name.tar.gz, $(du -h "$out/$name.tar.gz" | cut -f1)"
