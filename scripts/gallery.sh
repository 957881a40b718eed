#!/usr/bin/env bash
# Draws the pictures of docs/, and those of presets/pictures/, by which the window's user picks scenes and effects: installs what is missing,
# builds, renders, puts captions on. Arguments are the names of pictures; otherwise all of them are made. Every scene is shown at its default
# tick by the exact reference; every effect on a stage of its own, beside a person 1.78 m tall for scale. On two cores without a GPU all of it
# takes about ten minutes.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
pictures=(gallery_scenes gallery_effects preset_pictures fireball_layers street methods all_methods known_failures dolly)
[ $# -gt 0 ] || set -- "${pictures[@]}"
for picture; do
  [[ " ${pictures[*]} " == *" $picture "* ]] || { echo "no picture \`$picture\`, expected one of: ${pictures[*]}" >&2; exit 2; }
done

scripts/install.sh scripts/gallery_packages.txt
scripts/build.sh plume
work=out/gallery
mkdir -p "$work/tiles"

# How to see an effect: tick since its call, distance of the camera, its height and that of what it looks at, height of the effect's origin,
# degrees that it is turned by (0 if left out).
declare -A view=(
  [campfire]="300 3.2 1.1 0.7 0" [dust]="90 5.5 1.4 0.7 0" [explosion_ground]="45 14 2.4 2.8 0" [fireball]="50 10 2.6 2.6 0"
  [ground_mist]="660 11 2.2 0.8 0" [heat_haze]="300 4.5 1.5 1.0 0" [muzzle_flash]="21 2.4 1.45 1.35 1.35" [tracer]="25 9 1.9 1.6 1.2 60"
  [layered_fireball]="62 8 2.4 1.5 0" [marker]="60 3.4 1.7 1.7 1.95" [rust_smoke]="420 7 2.3 1.5 0" [signal_smoke]="330 8 2.8 2.0 0"
  [rain]="200 7 1.7 1.5 0" [steam]="200 6 1.7 1.3 0" [fog_bank]="2500 14 2.0 1.0 0" [glass_shatter]="22 4.5 1.5 1.1 0"
  [smoke_grenade]="430 9 2.6 1.7 0" [sparks]="240 5 1.6 1.0 0.8" [teal_smoke]="420 7 2.3 1.5 0"
)
any_view="90 7 2.0 1.3 0"   # an effect without a line above

# render OUT ARGUMENTS…: pictures of one frame each, without what is printed for people.
render() {
  local out=$work/$1
  shift
  rm -rf "$out"
  build/plume "$@" --out "$out" >/dev/null
}

# tile PICTURE CAPTION SIZE [CROP]: adds a picture with a line above it to the sheet that is being made.
tiles=()
tile() {
  local to=$work/tiles/${#tiles[@]}.png
  convert "$1" ${4:+-crop "$4" +repage} -resize "$3!" -background '#141416' -gravity northwest -splice 0x24 \
    -font DejaVu-Sans -pointsize 14 -fill '#e6e6e6' -annotate +7+4 "$2" "$to"
  tiles+=("$to")
}

# sheet FILE COLUMNS: the tiles so far, as a JPEG of at most 680 kB.
sheet() {
  montage "${tiles[@]}" -mode concatenate -background '#141416' -tile "$2x" "$work/sheet.png"
  convert "$work/sheet.png" -strip -sampling-factor 4:2:0 -quality 86 -define jpeg:extent=680kb "docs/$1"
  echo "docs/$1: $(stat -c %s "docs/$1") bytes" >&2
  tiles=()
}

ids() { build/plume list "$1" --json | grep -oP '^ {4}"id": "\K[^"]+'; }

# Once a run, for the gallery and for the small pictures.
render_scenes() {
  [ -z "${scenes+rendered}" ] || return 0
  mapfile -t scenes < <(ids scenes)
  render scenes compare "${scenes[@]}" --methods reference --frames 1 --size 640x360
}

draw_gallery_scenes() {
  render_scenes
  for scene in "${scenes[@]}"; do tile "$work/scenes/${scene}"_[0-9]*_reference.png "$scene" 400x225; done
  sheet gallery_scenes.jpg 4
}

stage() {   # EFFECT TICK DISTANCE CAMERA TARGET ORIGIN [YAW]: a scene that shows one effect
  cat <<END
name = "$1"
duration_ticks = 3600
default_tick = $2
exposure = 0.7
camera = { position = [0.0, $4, $3], target = [0.0, $5, 0.0], vertical_fov_deg = 36.0 }
light = { zenith = [0.08, 0.105, 0.165], horizon = [0.26, 0.243, 0.235], sun_direction = [-0.85, 0.55, 0.12], sun_color = [2.0, 1.6, 1.2] }
solid = [
  { kind = "plane", size_m = [200.0, 200.0], material = "concrete", color = [0.17, 0.165, 0.16] },
  { kind = "figure", position = [$(awk "BEGIN { print -0.3 * $3 }"), 0.0, -0.4], yaw_deg = 40.0, height_m = 1.78, color = [0.06, 0.06, 0.065] },
]
instance = [{ effect = "$1", call_tick = 0, position = [0.0, $6, 0.0], yaw_deg = ${7:-0.0}, seed = 7 }]
END
}

render_effects() {
  [ -z "${effects+rendered}" ] || return 0
  mapfile -t effects < <(ids effects)
  mkdir -p "$work/stages"
  local stages=()
  for effect in "${effects[@]}"; do
    stages+=("$work/stages/$effect.toml")
    # shellcheck disable=SC2086  # a view is several words
    stage "$effect" ${view[$effect]:-$any_view} >"${stages[-1]}"
  done
  render effects compare "${stages[@]}" --methods reference --frames 1 --size 640x360
}

draw_gallery_effects() {
  render_effects
  for effect in "${effects[@]}"; do tile "$work/effects/${effect}"_[0-9]*_reference.png "$effect" 400x225; done
  sheet gallery_effects.jpg 4
}

# small KIND ID: presets/pictures/KIND/ID.png, of the size that the window expects (sandbox/presets/library.h).
small() {
  convert "$work/$1/$2"_[0-9]*_reference.png -resize '160x90!' -dither FloydSteinberg -colors 128 -strip \
    -define png:compression-level=9 "PNG8:presets/pictures/$1/$2.png"
}

draw_preset_pictures() {
  render_scenes
  render_effects
  rm -rf presets/pictures
  mkdir -p presets/pictures/scenes presets/pictures/effects
  for scene in "${scenes[@]}"; do small scenes "$scene"; done
  for effect in "${effects[@]}"; do small effects "$effect"; done
  echo "presets/pictures: $(cat presets/pictures/*/*.png | wc -c) bytes" >&2
}

draw_fireball_layers() {
  # The left fireball three times: by hand, physical, and with its core as near as that of the right one.
  sed '/\[instance.layers\]/,+1d' presets/scenes/fireball_layers.toml >"$work/nearer_core.toml"
  render by_hand compare fireball_layers --methods sorted,avboit --set sorted.order=artist --frames 1 --size 1280x720
  render nearer compare "$work/nearer_core.toml" --methods avboit --frames 1 --size 1280x720
  tile "$work"/by_hand/*_sorted*artist.png "sorted by hand: the core is drawn after its smoke" 480x520 560x607+30+113
  tile "$work"/by_hand/*_avboit.png "avboit: light has no order, the smoke hides its core" 480x520 560x607+30+113
  tile "$work"/nearer/*_avboit.png "avboit, the core's layer 2.8 m towards the camera" 480x520 560x607+30+113
  sheet fireball_layers.jpg 3
}

draw_street() {
  render street compare street --methods reference --frames 1 --size 1280x720
  convert "$work"/street/*_reference.png -strip -quality 88 docs/street.jpg
}

draw_methods() {
  render methods compare street --methods avboit,wboit --frames 1 --size 640x360
  for method in avboit wboit; do
    tile "$work/methods/street_000400_$method.png" "$method" 640x360
    tile "$work/methods/street_000400_${method}_error.png" "$method: FLIP" 640x360
  done
  sheet methods.jpg 2
}

draw_all_methods() {
  local methods
  mapfile -t methods < <(ids methods)
  render all_methods compare street --methods all --frames 1 --size 640x360
  for method in "${methods[@]}"; do
    [ -e "$work/all_methods/street_000400_$method.png" ] || continue   # a device may lack what it needs
    tile "$work/all_methods/street_000400_$method.png" "$method" 320x180
  done
  sheet all_methods.jpg 4
}

# row SCENE METHOD…: their pictures, the scene's name before the first caption. A method may be METHOD:PARAMETER=VALUE.
row() {
  local scene=$1 caption="$1: " wanted method setting
  shift
  for wanted; do
    IFS=: read -r method setting <<<"$wanted"
    render row compare "$scene" --methods "$method" ${setting:+--set "$method.$setting"} --frames 1 --size 640x360
    rm "$work"/row/*_error.png
    tile "$work/row/$scene"_*.png "$caption$method${setting:+, $setting}" 320x180
    caption=""
  done
}

draw_known_failures() {
  row three_cards reference moments wboit avboit
  row behind_smoke reference moments wboit avboit
  row cages reference wboit coloured phenomenological
  row peeling_comparison peel wboit avboit
  row ground_glass phenomenological
  row interleaved reference sorted:order=cpu sorted:order=gpu_all avboit
  sheet known_failures.jpg 4
}

draw_dolly() {
  render dolly replay card_dolly
  for method in "wavelets-exclude_self-false*" "vboit*" avboit; do
    for tick in 20 60 100 140 180; do
      # shellcheck disable=SC2086  # a pattern
      tile "$work/dolly/card_dolly_$(printf %06d $tick)"_$method.png "${method%%[-*]*} $tick" 240x135
    done
  done
  sheet dolly.jpg 5
}

for picture; do "draw_$picture"; done
