#!/bin/bash
# Builds truequad and shows what it does: runs ordinary OpenGL programs without and with it and leaves in out/
#   NAME-before.png  NAME-after.png  NAME-mesh.png   the pictures, the last one with the mesh drawn over corrected quads
#   NAME-sheet.png                                   before | after | difference
#   table.md                                         quads, triangles, errors and times, also printed
# Samples (samples/) draw with OSMesa, two real programs of Debian on an X server without a screen. Errors are measured: the
# samples draw a texture that tells its own coordinates, which samples/measure compares with the exact map.
# Ends with status 1 if a sample's error with truequad exceeds the tolerance.
set -Eeuo pipefail
cd "$(dirname "$0")"
source tests/packages.sh

fail() { echo "demo.sh: $*" >&2; exit 1; }
trap 'echo "demo.sh: stopped at line $LINENO: $BASH_COMMAND" >&2' ERR

[ $# = 0 ] || { echo "usage: $0" >&2; exit 2; }

readonly tolerance_px=0.25
readonly out=out work=out/work build=build/release
readonly samples=$build/samples measure=$build/samples/measure/measure
readonly truequad=$build/shim/truequad steady=$PWD/$build/tests/programs/steady.so
readonly frames_timed=30 rounds=3

install_packages build samples tests programs || fail "packages are missing"

mkdir -p build "$work"
{ cmake --preset release && cmake --build --preset release -j "$(nproc)" --target truequad truequad_command samples measure steady; } \
  >build/demo.log 2>&1 || { tail -n 40 build/demo.log >&2; fail "the build failed"; }

# --- Figures ----------------------------------------------------------------------------------------------------------

figure() {  # figure KEY FILE: a top-level number of the statistics
  local value
  value=$(grep -Eo "\"$1\": *[0-9]+" "$2" | head -n 1 | grep -Eo '[0-9]+$') || fail "no $1 in $2"
  echo "$value"
}

median() { sort -n | awk '{ x[NR] = $1 } END { printf "%.2f\n", x[int((NR + 1) / 2)] }'; }

changed() {  # changed PNG PNG: percentage of pixels that differ
  local count pixels
  count=$(compare -metric AE "$1" "$2" null: 2>&1) || [ $? = 1 ] || fail "cannot compare $1 with $2"
  pixels=$(identify -format '%[fx:w*h]' "$1")
  awk -v count="$count" -v pixels="$pixels" 'BEGIN { printf "%.1f\n", 100 * count / pixels }'
}

declare -a table=()
late=()

row() {  # row NAME LABEL ERROR_BEFORE ERROR_AFTER MS_BEFORE MS_AFTER
  local stats=$work/$1.stats
  table+=("| $2 | $(figure quads "$stats") | $(figure corrected "$stats") | $(figure triangles "$stats") | $3 | $4 | $5 | $6 | $(
    changed "$out/$1-before.png" "$out/$1-after.png") |")
  echo "${table[-1]}"
}

# --- Pictures ---------------------------------------------------------------------------------------------------------

sheet() {  # sheet NAME LABEL
  local before=$out/$1-before.png after=$out/$1-after.png
  local look=(-font DejaVu-Sans -pointsize 18 -background white -bordercolor white)
  local titled=(-border 4x0 -gravity north -splice 0x32 -annotate +0+6)
  # The difference is shown three times as strong, white where there is none.
  convert "$before" "$after" -alpha off -compose difference -composite -evaluate multiply 3 -negate "$work/difference.png"
  convert "${look[@]}" \
    \( "$before" "${titled[@]}" without \) \( "$after" "${titled[@]}" 'with truequad' \) \
    \( "$work/difference.png" "${titled[@]}" difference \) \
    +append +repage -gravity south -splice 0x32 -annotate +0+6 "$2" "$out/$1-sheet.png"
}

# sample NAME LABEL MODE MAP PROGRAM ARGS…
sample() {
  local name=$1 label=$2 mode=$3 map=$4 program=$samples/$5 side pass round
  shift 5
  local with=("$truequad" --mode "$mode" --tolerance "$tolerance_px")
  local error=()
  : >"$work/$name.before.ms" >"$work/$name.after.ms"
  for side in before after; do
    local run=()
    [ $side = before ] || run=("${with[@]}")
    for pass in coarse fine; do
      "${run[@]}" "$program" "$@" --coordinates $pass --out "$work/$name-$side-$pass.png"
    done
    "${run[@]}" "$program" "$@" --out "$out/$name-$side.png" --quads "$work/$name-$side.json"
    cmp -s "$work/$name-before.json" "$work/$name-$side.json" || fail "$name: the runs drew different quads"
    local words
    read -r -a words < <("$measure" --map "$map" --quads "$work/$name-$side.json" \
      --coarse "$work/$name-$side-coarse.png" --fine "$work/$name-$side-fine.png") || fail "$name: cannot be measured"
    error+=("${words[3]}")
    # Texels that the exact map has nowhere count as wrong.
    [ $side = before ] || [ "${words[7]}" = 0 ] || late+=("$name: ${words[7]} texels out of place")
  done
  "${with[@]}" --stats "$work/$name.stats" "$program" "$@" --out "$work/$name-again.png"
  "${with[@]}" --overlay "$program" "$@" --out "$out/$name-mesh.png"
  for ((round = 0; round < rounds; ++round)); do
    "$program" "$@" --repeat $frames_timed --time 2>>"$work/$name.before.ms"
    "${with[@]}" "$program" "$@" --repeat $frames_timed --time 2>>"$work/$name.after.ms"
  done
  awk -v error="${error[1]}" -v tolerance=$tolerance_px 'BEGIN { exit !(error <= tolerance) }' ||
    late+=("$name: ${error[1]} px exceed $tolerance_px px")
  sheet "$name" "$label"
  row "$name" "$label" "${error[@]}" "$(median <"$work/$name.before.ms")" "$(median <"$work/$name.after.ms")"
}

# real NAME LABEL FRAME PROGRAM ARGS…: an unmodified program with a steady clock (tests/programs/steady.cc), so that the
# pictures with and without truequad show the same moment. Its errors cannot be measured: nobody knows its quads.
real() {
  local name=$1 label=$2 frame=$3 side round
  shift 3
  [ -x "$(command -v "$1")" ] || fail "$1 is not installed"
  run() {  # run FRAME PREFIX [TRUEQUAD…] -- PROGRAM ARGS…
    local last=$1 prefix=$2 with=() status=0
    shift 2
    while [ "$1" != -- ]; do with+=("$1"); shift; done
    shift
    mkdir -p "$work/home"
    # The command hands its own process to the program, so the steady world that begins in it goes on there.
    tests/programs/with_display timeout -k 5 120 env -u XAUTHORITY -u STEADY_OWNER HOME="$PWD/$work/home" LC_ALL=C \
      LIBGL_ALWAYS_SOFTWARE=1 MESA_SHADER_CACHE_DISABLE=true \
      STEADY_FRAMES="$last" STEADY_OUT="$PWD/$prefix" LD_PRELOAD="$steady" "${with[@]}" "$@" \
      >"$work/$name.log" 2>&1 </dev/null || status=$?
    [ $status = 0 ] && [ -s "$prefix-$last.png" ] || { tail -n 5 "$work/$name.log" >&2; fail "$name ended with status $status"; }
  }
  run "$frame" "$work/$name-before" -- "$@"
  run "$frame" "$work/$name-after" "$truequad" --tolerance $tolerance_px --stats "$PWD/$work/$name.stats" -- "$@"
  run "$frame" "$work/$name-mesh" "$truequad" --tolerance $tolerance_px --overlay -- "$@"
  for side in before after mesh; do mv "$work/$name-$side-$frame.png" "$out/$name-$side.png"; done
  # Start and end cost the same for few frames as for many.
  local few=20 many=120
  time_of() { local start=$EPOCHREALTIME; run "$@"; awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }'; }
  per_frame() {
    local t_few t_many
    t_few=$(time_of $few "$work/$name-timed" "$@")
    t_many=$(time_of $many "$work/$name-timed" "$@")
    awk -v a="$t_few" -v b="$t_many" -v n=$((many - few)) 'BEGIN { printf "%.3f\n", 1000 * (b - a) / n }'
  }
  : >"$work/$name.before.ms" >"$work/$name.after.ms"
  for ((round = 0; round < rounds; ++round)); do
    per_frame -- "$@" >>"$work/$name.before.ms"
    per_frame "$truequad" --tolerance $tolerance_px -- "$@" >>"$work/$name.after.ms"
  done
  sheet "$name" "$label"
  row "$name" "$label" – – "$(median <"$work/$name.before.ms")" "$(median <"$work/$name.after.ms")"
}

# --- The demonstration ------------------------------------------------------------------------------------------------

head_lines() {
  echo '| program | quads | corrected | triangles | error before, px | after, px | ms per frame without | with | pixels changed, % |'
  echo '|---|--:|--:|--:|--:|--:|--:|--:|--:|'
}
head_lines
sample photograph 'facade, the photograph itself' bilinear bilinear facade --figure 1
sample facade 'facade on a rectangle' bilinear bilinear facade --figure 2
sample facade-projective 'facade on a rectangle, --mode projective' projective projective facade --figure 2
sample house 'facade, turned house' bilinear bilinear facade --figure 3
sample trapezoid 'trapezoid' bilinear bilinear trapezoid --order abcd
sample trapezoid-turned 'trapezoid, other vertex order' bilinear bilinear trapezoid --order bcda
for area in 33600 11879 3051 795 197; do
  sample trapezoid-$area "trapezoid, slanted patch, $area px" bilinear bilinear trapezoid --patch slanted --area $area
done
sample patch-arbitrary 'patches, arbitrary on arbitrary' bilinear bilinear patches --figure 12
sample patch-dragged 'patches, dragged vertex in perspective' bilinear bilinear patches --figure 14
sample patch-bent 'patches, not planar' bilinear bilinear patches --figure 15
sample patch-affine 'patches, affine copy' bilinear bilinear patches --figure 16
sample keystone 'keystone' bilinear bilinear keystone
sample tunnel 'tunnel' bilinear bilinear tunnel --frame 20
real atunnel 'atunnel (xscreensaver), first 40 frames' 40 /usr/libexec/xscreensaver/atunnel -window -geometry 640x480
real gem-polygon 'Pd Gem, polygon 4, first 10 frames' 10 \
  pd -nogui -nrt -noaudio -nomidi -path /usr/lib/pd/extra/Gem -lib Gem -open tests/programs/gem/polygon4.pd
{ head_lines; printf '%s\n' "${table[@]}"; } >"$out/table.md"

[ ${#late[@]} = 0 ] || fail "tolerance not kept: $(printf '%s; ' "${late[@]}")"
echo "demo.sh: pictures and table.md are in $out/ ($SECONDS s)"
