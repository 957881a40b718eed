#!/usr/bin/env bash
# What accuracy costs in time: plays the replay accuracy_cost (or goes on with it), keeps its page as docs/accuracy_cost.html and the page's
# main plot as docs/accuracy_cost.png, and prints the page's first table for the README. Takes some 20 minutes on two cores without a GPU,
# which should have nothing else to do: the page says where they had. Arguments are handed on, such as --device NAME or --size 3840x2160.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

scripts/install.sh
scripts/build.sh plume
work=out/accuracy_cost
build/plume replay accuracy_cost --report-limit 2 --resume --out "$work" "$@" >"$work.txt"
cp "$work/report.html" docs/accuracy_cost.html

url="file://$PWD/docs/accuracy_cost.html#sort=own"   # the fastest first
page() { chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --virtual-time-budget=5000 --window-size=1300,1500 "$@" "$url" 2>"$work.chromium.txt"; }
page --screenshot="$PWD/$work/page.png" --force-device-scale-factor=1.5
read -r top height < <(page --dump-dom | grep -oP 'data-scatter="\K[0-9]+ [0-9]+')   # of the plot, as the page tells
convert "$work/page.png" -crop "1950x$((height * 3 / 2))+0+$((top * 3 / 2))" +repage -strip -colors 64 docs/accuracy_cost.png
echo "docs/accuracy_cost.html: $(stat -c %s docs/accuracy_cost.html) bytes, docs/accuracy_cost.png: $(stat -c %s docs/accuracy_cost.png) bytes" >&2

page --dump-dom | python3 scripts/first_table.py | sed -E '3,$s/^\| ([^|★]+) (★ )?\|/| `\1` \2|/'
