#!/usr/bin/env bash
# Installs the Debian packages of scripts/packages.txt, or of the list that is given, that are missing. Says which before it does. Needs root
# or sudo for that.
set -euo pipefail
list="${1:-$(dirname "$(readlink -f "$0")")/packages.txt}"

missing=()
while read -r package; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done < <(grep -v '^#' "$list")
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Plume needs these Debian packages, which will be installed now: ${missing[*]}" >&2
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Neither root nor sudo: please install them by hand, then run this again." >&2; exit 1; }
  as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q >&2
"${as_root[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}" >&2
