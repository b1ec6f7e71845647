#!/usr/bin/env bash
# Makes docs/tutorial/report.png: of the report of problems/cams/roller_least_base.toml its head with the tiles, the
# cam in motion and the first curves. The other sections are left out of the picture.
#   docs/tutorial/report.sh [PROGRAM]      by default the program of build/release; needs chromium
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
camlaw=${1:-$root/build/release/cli/camlaw}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$camlaw" optimize "$root/problems/cams/roller_least_base.toml" --out "$work" >"$work/log"
"$camlaw" report "$work/result.json" -o "$work/report.html" >"$work/log"
left_out='#motion p,#curves>p,#problem,#values,#limits,#buildable,#sensitivity,#numbers,#provenance{display:none}'
sed -i "s|</head>|<style>$left_out</style></head>|" "$work/report.html"
# The clock of the page runs ahead, so that its drawings are done when the picture is taken.
chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --force-device-scale-factor=1 \
  --user-data-dir="$work/profile" --window-size=1280,1560 --virtual-time-budget=8000 \
  --screenshot="$work/report.png" "file://$work/report.html" 2>"$work/log" || {
  cat "$work/log" >&2
  exit 1
}
size=$(stat -c %s "$work/report.png")
[ "$size" -lt 200000 ] || { echo "report.sh: the picture has $size bytes, more than 200000" >&2; exit 1; }
mv "$work/report.png" "$root/docs/tutorial/report.png"
echo "wrote docs/tutorial/report.png, $size bytes"
