#!/usr/bin/env bash
# Walks through the real window as a person would, on a display that nobody sees (Xvfb, xdotool), with the validation layer on, and keeps
# screenshots: start; scrub; every method; the crosshair on three cards; every chromatic mode; views; an effect edited, saved, broken and
# mended on disk; a recording that `plume replay` plays to the same pictures; 200 resizes; the end. Fails on the first thing that is not as
# it should be, on any validation message, on anything the program says, and unless it ends with exit code 0.
#
#   scripts/tour.sh                   builds, walks, keeps out/tour/*.png
#   scripts/tour.sh --asan            the same with the address, leak and undefined-behaviour sanitizers (build-asan/, out/tour_asan/)
#   scripts/tour.sh --short           a few methods, a few resizes: for the tests
#   scripts/tour.sh --program FILE    walks through that one and builds nothing
#   scripts/tour.sh --out DIR         keeps the screenshots there
#   scripts/tour.sh --docs            makes the pictures of docs/window.md of them
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
root=$PWD short='' asan='' docs='' program='' out='' patience=60
while [ $# -gt 0 ]; do
  case $1 in
    --short) short=yes ;;
    --asan) asan=yes ;;
    --docs) docs=yes ;;
    --program) program=$(readlink -f "$2"); shift ;;
    --out) out=$2; shift ;;
    *) echo "unknown argument \`$1\`, expected --short, --asan, --docs, --program FILE or --out DIR" >&2; exit 2 ;;
  esac
  shift
done
if [ -z "$program" ]; then
  scripts/install.sh
  if [ "$asan" ]; then
    cmake --preset asan >&2
    cmake --build --preset asan --target plume >&2
    program=$root/build-asan/plume
  else
    scripts/build.sh plume
    program=$root/build/plume
  fi
fi
if [ "$asan" ]; then
  patience=180
  export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
  export LSAN_OPTIONS=suppressions=$root/scripts/leaks_of_drivers.txt:print_suppressions=0
fi
out=${out:-out/tour${asan:+_asan}}
mkdir -p "$out"
out=$(readlink -f "$out")
rm -rf "$out"/*.png "$out"/session

# ---- a desk: display, presets of one's own, folders of one's own -------------------------------------------------------------------------

session=$out/session
[ -z "$docs" ] || session=$(mktemp -d -t plume.XXX)   # is seen in the pictures
places=$session/places
mkdir -p "$session/display"
cp -r presets "$session/presets"
export PLUME_PRESETS=$session/presets PLUME_CONFIG=$session/config PLUME_CACHE=$session/cache
mkfifo "$session/display/number"
Xvfb -displayfd 3 -screen 0 1280x720x24 -fbdir "$session/display" -nolisten tcp 3>"$session/display/number" 2>"$session/display/said" &
xvfb=$!
read -r DISPLAY <"$session/display/number"
export DISPLAY=:$DISPLAY WAYLAND_DISPLAY=''
plume=''
leave() {
  [ -z "$plume" ] || kill -KILL "$plume" 2>/dev/null || true
  kill "$xvfb" 2>/dev/null || true
  [ -z "$docs" ] || rm -rf "$session"
}
trap leave EXIT

# ---- eyes and hands ----------------------------------------------------------------------------------------------------------------------

say() { printf '%4d s  %s\n' "$SECONDS" "$*" >&2; }

see() {   # NAME: keeps what is on the screen
  convert "xwd:$session/display/Xvfb_screen0" -strip "$out/$1.png"
}

fail() {
  say "FAILED: $*"
  see failed || true
  [ ! -s "$session/said" ] || sed 's/^/    /' "$session/said" | head -60 >&2
  exit 1
}

is_open() { kill -0 "$plume" 2>/dev/null; }

# wait_for WHAT COMMAND…: until the command succeeds.
wait_for() {
  local what=$1 end=$((SECONDS + patience))
  shift
  until "$@"; do
    is_open || fail "the window is gone; waited for $what"
    [ $SECONDS -lt $end ] || fail "waited in vain for $what"
    sleep 0.03
  done
}

# place WIDGET: left top right bottom. state WIDGET: what its name goes on with, after " = ". See sandbox/debugger/widget_places.h.
place() { sed -nE "s/^(-?[0-9]+ -?[0-9]+ -?[0-9]+ -?[0-9]+) $(quoted "$1")( = .*)?$/\1/p" "$places" 2>/dev/null | head -1; }
state() { sed -nE "s/^(-?[0-9]+ ){4}$(quoted "$1") = //p" "$places" 2>/dev/null | head -1; }
quoted() { sed 's/[][\.*^$(){}?+|/]/\\&/g' <<<"$1"; }
names() { sed -nE "s/^(-?[0-9]+ ){4}($1.*)/\2/p" "$places"; }
is() { [ "$(state "$1")" = "$2" ]; }
is_there() { [ -n "$(place "$1")" ]; }
is_gone() { [ -z "$(place "$1")" ]; }
is_drawn() { [[ $(state picture) =~ ^[0-9]+$ ]]; }
drawn() { wait_for "the picture" is_drawn; }

frame() { state frame; }
has_passed() { [ "$(frame)" -ge "$1" ] 2>/dev/null; }
next_frames() {   # what was done before is seen by then
  wait_for "the next frame" has_passed $(($(frame) + 2))
}
stands_still() {   # the widget, since the last look
  local now
  now=$(place "$1")
  if [ -n "$now" ] && [ "$now" = "$stood" ]; then return; fi
  stood=$now
  next_frames
  return 1
}
find_place() {   # WIDGET: sets left, top, right, bottom once it stays where it is
  stood=''
  wait_for "the widget \`$1\`" stands_still "$1"
  read -r left top right bottom <<<"$stood"
}
hand() {   # xdotool's words; the window has seen it when this returns
  xdotool "$@"
  next_frames
}
press_at() {
  hand mousemove "$1" "$2"
  hand mousedown 1
  hand mouseup 1
}
click() {   # WIDGET
  find_place "$1"
  press_at $(((left + right) / 2)) $(((top + bottom) / 2))
}
key() {
  wait_for "the window to listen to keys" is window listens
  hand key "$@"
}

is_in_reach() {   # all of it, above the timeline
  local top bottom
  read -r _ top _ bottom <<<"$(place "$1")"
  [ -n "$bottom" ] && [ "$top" -ge 0 ] && [ "$bottom" -le "$(cut -d' ' -f2 <<<"$(place tick)")" ]
}
reveal() {   # WIDGET PANEL: turns the wheel over the panel's dock until the widget is seen
  local x i
  find_place "$2"
  x=$(((left + right) / 2))
  for ((i = 0; i < 40; ++i)); do
    ! is_in_reach "$1" || return 0
    hand mousemove $x 500
    hand click 5
  done
  fail "\`$1\` is nowhere in the dock of $2"
}

choose_scene() {   # of pictures, of which not all are seen at once
  click scene
  wait_for "the list of scenes" is window types
  hand type "$1"
  click "scene: $1"
  wait_for "the scene to be $1" is scene "$1"
  drawn
}
choose() {   # LIST ITEM: opens a list and takes one of it
  click "$1"
  click "$1: $2"
  wait_for "$1 to be $2" is "$1" "$2"
  drawn
}

pixels() { cksum <"$session/display/Xvfb_screen0"; }
shows_the_same() {
  local now
  now=$(pixels)
  sleep 0.15
  [ "$now" = "$(pixels)" ]
}
shot() {   # NAME: keeps what is on the screen once that stands still, the pointer out of the way
  hand mousemove 640 2
  drawn
  wait_for "the screen to stand still" shows_the_same
  see "$1"
  say "$1"
}

picture() {   # NAME: saves the picture, by the key
  local file=$session/plume_picture_$((++pictures)).png
  key F12
  wait_for "$file" test -s "$file"
}
pictures=0

# ---- the walk ----------------------------------------------------------------------------------------------------------------------------

begin=$(date +%s%N)
cd "$session"
PLUME_WIDGET_PLACES=$places "$program" open street --validate >"$session/out" 2>"$session/said" &
plume=$!

see_the_start() {
  drawn
  say "first picture after $((($(date +%s%N) - begin) / 1000000)) ms"
  wait_for "half a second to be played" awk -v tick="$(state tick)" 'BEGIN { exit !(tick > 10) }'
  hand mousemove 640 200
  key space
  wait_for "a pause" is play paused
  shot 01_start
  # From here on the same however busy the machine is.
  click hold
  wait_for "the resolution to stay" is hold false
  choose resolution "$([ "$short" ] && echo 25 || echo 50) %"
}

scrub() {
  local share first
  find_place tick
  hand mousemove $((left + 8)) $(((top + bottom) / 2))
  hand mousedown 1
  for share in 10 30 60 90 55; do
    hand mousemove $((left + (right - left) * share / 100)) $(((top + bottom) / 2))
    drawn
  done
  hand mouseup 1
  drawn
  shot 02_scrubbed
  # The same tick again, from the other side, is the same picture to the bit.
  first=$(state tick)
  hand mousemove 640 200
  picture
  key Home
  wait_for "the first tick" is tick 0
  find_place tick
  hand mousemove $(((left + right) / 2)) $(((top + bottom) / 2)) keydown ctrl
  hand mousedown 1
  hand mouseup 1 keyup ctrl
  wait_for "the slider to take text" is window types
  hand type "$first"
  wait_for "tick $first" is tick "$first"
  xdotool keydown Return   # ImGui knows which keys are down, not which were pressed
  wait_for "the end of typing" is window listens
  xdotool keyup Return
  drawn
  hand mousemove 640 200
  picture
  cmp -s plume_picture_1.png plume_picture_2.png || fail "tick $first is another picture after a scrub"
}

switch_methods() {
  local methods method
  click method
  wait_for "the list of methods" is_there "method: avboit"
  mapfile -t methods < <(names 'method: ' | sed 's/^method: //' | grep -v '(unavailable)')
  click "method: avboit"
  wait_for "the list to close" is method avboit
  [ ${#methods[@]} -ge 20 ] || fail "only ${#methods[@]} methods are in the list"
  [ -z "$short" ] || methods=(moments wboit)
  for method in "${methods[@]}"; do
    choose method "$method"
    shot "03_method_$method"
  done
  choose method avboit
}

# at X Y DEPTH: clicks on a place of the scene three_cards, whose camera is 8 m before its origin and sees 30 degrees.
at() {
  find_place picture
  read -r x y < <(awk -v x="$1" -v y="$2" -v z="$3" -v l="$left" -v t="$top" -v r="$right" -v b="$bottom" 'BEGIN {
    scale = (b - t) / 2 / (8 - z) / (sin(0.2618) / cos(0.2618)); printf "%d %d\n", (l + r) / 2 + x * scale, (t + b) / 2 - y * scale }')
  press_at "$x" "$y"
}
reads() { [[ $(state graph) =~ ^$1\ fragments ]]; }
place_crosshair() {
  local count pixel size
  choose_scene three_cards
  at 0 0.1 0
  wait_for "the crosshair" is_there graph
  at -1.2 0.3 0         # red alone, in the smoke
  wait_for "13 fragments: a card in 12 layers" reads 13
  shot 04_crosshair_one_card
  at 0.8 -0.4 -1        # green, and blue behind it
  wait_for "14 fragments" reads 14
  at 0.1 0.2 0
  wait_for "15 fragments" reads 15
  click curves
  click "curve moments"
  wait_for "a curve of moments" is "curve moments" true
  press_at 640 300      # which closes the list, and places the crosshair there
  wait_for "the answer" reads '1[0-9]'
  at 0.1 0.2 0
  wait_for "15 fragments" reads 15
  shot 05_crosshair_three_cards
  read -r count pixel size < <(state graph | sed -E 's/ fragments at / /; s/ of / /')
  "$program" probe three_cards --at "$(state tick)" --size "$size" --pixel "$pixel" --methods avboit >"$session/probe.json" || fail "plume probe"
  [ "$(grep -c '"card"' "$session/probe.json")" = "$count" ] || fail "plume probe has not $count fragments at $pixel of $size"
  key Escape
  wait_for "the crosshair to go" is_gone graph
}

press_in() {   # TOGGLE, of which one is pressed in
  click "$1"
  wait_for "$1 to be chosen" is "$1" true
  drawn
}

toggle_colours() {
  local modes mode
  choose_scene coloured
  reveal "parameter skew_guard" Method
  mapfile -t modes < <(names 'parameter colour ' | sed 's/^parameter colour \(.*\) = .*/\1/')
  [ "${#modes[@]}" -ge 5 ] || fail "there are ${#modes[@]} chromatic modes"
  for mode in "${modes[@]}"; do
    [ -z "$short" ] || [[ $mode = skew || $mode = rgb ]] || continue
    press_in "parameter colour $mode"
    shot "06_colour_$mode"
    [ "$mode" = skew ] || continue
    click "parameter skew_guard"
    wait_for "no guard" is "parameter skew_guard" false
    shot "06_colour_skew_unguarded"
    click "parameter skew_guard"
    wait_for "the guard" is "parameter skew_guard" true
  done
}

look_at_views() {
  local view
  choose view flip
  shot 07_view_error
  if [ -z "$short" ]; then
    for view in overdraw culling_depth integral; do
      choose view $view
      shot "07_view_$view"
    done
    choose view flip
  fi
  key v
  wait_for "the split view" is "comparison split" true
  drawn
  shot 08_split
  key v
  wait_for "one picture" is "comparison one" true
  choose view picture
}

edit_effect() {
  local file=$session/presets/effects/smoke_grenade.toml field line
  choose_scene grenade
  cp "$file" "$session/before.toml"
  click 'grenade / smoke'
  field='emitter[0].motion.drag'
  reveal "$field" Effects
  find_place "$field"
  hand mousemove $(((left + right) / 2)) $(((top + bottom) / 2))
  hand mousedown 1
  for line in 10 20 30 40; do hand mousemove_relative 10 0; done
  hand mouseup 1
  drawn
  shot 09_effect_edited
  key ctrl+s
  wait_for "the file to change" bash -c "! cmp -s '$file' '$session/before.toml'"
  [ "$(diff "$file" "$session/before.toml" | grep -c '^<')" = 1 ] || fail "saving one number changed $(diff "$file" "$session/before.toml")"
  cp "$file" "$session/good.toml"
  hand mousemove 150 500
  hand click --repeat 30 --delay 10 4   # up, to where the panel says what is wrong
  line=$(grep -n '^ *life = ' "$file" | head -1 | cut -d: -f1)
  sed "${line}s/= .*/= oops/" "$session/good.toml" >"$session/broken.toml"
  cp "$session/broken.toml" "$file"
  wait_for "the mistake" is_there warning
  [[ $(state warning) =~ "the last good one runs".*smoke_grenade.toml:$line:[0-9]+: ]] || fail "the panel says: $(state warning)"
  shot 10_effect_broken
  cp "$session/good.toml" "$file"
  wait_for "the mistake to go" is_gone warning
  drawn
}

record() {
  local shot_of=() number
  keep() {   # what is shown now is this shot
    drawn
    picture
    shot_of[pictures]=$(state record)
  }
  hand mousemove 640 200
  key ctrl+r
  wait_for "the recording" is record 1
  keep
  choose method wboit
  keep
  choose view flip
  keep
  choose view picture
  click "freeze $(names 'mute' | head -1 | sed 's/^mute \(.*\) = .*/\1/')"
  key Right
  keep
  click "$(names 'mute' | head -1 | sed 's/ = .*//')"
  keep
  hand mousemove 500 200
  hand mousedown 1
  hand mousemove 560 220
  hand mouseup 1
  keep
  choose method avboit
  shot 11_recording
  keep
  number=$(state record)
  hand mousemove 640 200
  key ctrl+r
  wait_for "the end of the recording" is record off
  [ -s plume_recording_1.toml ] || fail "there is no plume_recording_1.toml"
  say "recorded $number pictures; plume replay plays them"
  "$program" replay ./plume_recording_1.toml --out replayed --validate >replay.out 2>&1 || fail "plume replay: $(tail -5 replay.out)"
  for number in "${!shot_of[@]}"; do
    cmp -s plume_picture_"$number".png "$(printf 'replayed/shot_%06d' "${shot_of[number]}")"_*.png ||
      fail "the replay's picture ${shot_of[number]} is not what was seen, plume_picture_$number.png"
  done
  say "${#shot_of[@]} of its pictures were saved by hand and are the same to the bit"
}

has_size() { [ "$(place window)" = "0 0 $1 $2" ] && is_drawn; }
resize() {
  local i width height window count=200
  [ -z "$short" ] || count=12
  choose_scene three_cards
  window=$(xdotool search --onlyvisible --name Plume | head -1)
  for ((i = 1; i <= count; ++i)); do
    width=$((320 + i * 211 % 961)) height=$((180 + i * 157 % 541))
    xdotool windowsize "$window" $width $height
    wait_for "$width x $height" has_size $width $height
  done
  see 12_resized
  xdotool windowsize "$window" 1280 720
  wait_for "1280 x 720" has_size 1280 720
  say "resized $count times"
}

close() {
  local code=0
  hand mousemove 640 200
  xdotool key Escape
  for ((i = 0; i < patience * 20; ++i)); do
    is_open || break
    sleep 0.05
  done
  ! is_open || fail "Esc does not close the window"
  wait "$plume" || code=$?
  plume=''
  [ $code = 0 ] || fail "exit code $code"
  [ ! -s "$session/said" ] || fail "the program said"
}

see_the_start
scrub
switch_methods
place_crosshair
toggle_colours
look_at_views
edit_effect
record
resize
close
say "no message, no leak, exit code 0: $(find "$out" -maxdepth 1 -name '*.png' | wc -l) screenshots in $out"
if [ "$docs" ]; then
  for name in 02_scrubbed 05_crosshair_three_cards 06_colour_rgb 08_split 09_effect_edited 10_effect_broken 11_recording; do
    convert "$out/$name.png" -dither None -colors 160 -define png:compression-level=9 -strip "PNG8:$root/docs/tour_${name#*_}.png"
  done
  say "docs/tour_*.png: $(cat "$root"/docs/tour_*.png | wc -c) bytes"
fi
