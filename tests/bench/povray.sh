#!/usr/bin/env bash
# Times Eyeray against POV-Ray 3.7 on the homage scene and on a knot of 70,000 triangles in mirror and in glass: 1280x720,
# one sample per pixel, depth 5, two threads. Both in turn, so that whatever else the machine does hits both. Start-up, a
# picture of one pixel, is taken off.
# usage: tests/bench/povray.sh [REPETITIONS] [FOLDER for the pictures]
set -euo pipefail
repetitions=${1:-7}
pictures=${2:-}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
eyeray=$root/build/release/eyeray

command -v povray >/dev/null || { echo "povray.sh: POV-Ray is missing: apt-get install povray" >&2; exit 1; }
for program in "$eyeray" "$root/build/release/eyeray_pov_mesh"; do
  [ -x "$program" ] || { echo "povray.sh: $program is missing: build it first" >&2; exit 1; }
done
scenes=$root/tests/bench/povray
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$root/build/release/eyeray_pov_mesh" >"$work/knot.inc"

declare -A eyerayScene=([homage]=homage [mirror]=$scenes/mirror.gltf [glass]=$scenes/glass.gltf)
declare -A povrayScene=([homage]="+I$scenes/homage.pov" [mirror]="+I$scenes/mesh.pov" [glass]="+I$scenes/mesh.pov Declare=Glass=1")

runEyeray() {
  "$eyeray" render "${eyerayScene[$1]}" --samples 1 --threads 2 --quiet --width "$2" --height "$3" -o "$work/$1-eyeray.png"
}
runPovray() {
  # shellcheck disable=SC2086 # two words
  povray ${povrayScene[$1]} "+L$work" "+O$work/$1-povray.png" "+W$2" "+H$3" +WT2 -D -A -GA +FN8 >/dev/null 2>"$work/log" ||
    { cat "$work/log" >&2; exit 1; }
}

# Wall and CPU seconds of one run, as a line of FILE.
measure() {
  local file=$1 TIMEFORMAT='%R %U %S'
  shift
  { time "$@" 2>&3; } 3>&2 2>"$work/time"
  awk '{print $1, $2 + $3}' "$work/time" >>"$file"
}

median() { cut -d' ' -f"$2" "$1" | sort -n | awk '{v[NR] = $1} END {print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2}'; }

echo "1280x720, depth 5, one sample, 2 threads; medians of $repetitions runs in turn; load $(cut -d' ' -f1 /proc/loadavg)"
for scene in homage mirror glass; do
  for _ in $(seq "$repetitions"); do
    for program in Eyeray Povray; do
      measure "$work/$scene.$program.start" "run$program" "$scene" 1 1
      measure "$work/$scene.$program.whole" "run$program" "$scene" 1280 720
    done
  done
  [ -z "$pictures" ] || { mkdir -p "$pictures" && cp "$work/$scene"-*.png "$pictures"; }
  for column in 1 2; do
    awk -v what="$scene, $([ $column = 1 ] && echo wall || echo CPU)" \
      -v e="$(median "$work/$scene.Eyeray.whole" $column)" -v e0="$(median "$work/$scene.Eyeray.start" $column)" \
      -v p="$(median "$work/$scene.Povray.whole" $column)" -v p0="$(median "$work/$scene.Povray.start" $column)" \
      'BEGIN {
        printf "%-12s  Eyeray %.3f s (start-up %.3f)   POV-Ray %.3f s (start-up %.3f)   ", what, e, e0, p, p0
        printf "POV-Ray / Eyeray: %.1f whole, %.1f without start-up\n", p / e, (p - p0) / (e - e0)
      }'
  done
done
