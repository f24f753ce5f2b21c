#!/usr/bin/env bash
# Times Eyeray against POV-Ray 3.7 on the homage scene: 1280x720, one sample per pixel, depth 5, two threads. Both in
# turn, so that whatever else the machine does hits both. Start-up, a picture of one pixel, is taken off.
# usage: tests/bench/povray.sh [REPETITIONS] [FOLDER for the two pictures]
set -euo pipefail
repetitions=${1:-7}
pictures=${2:-}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
eyeray=$root/build/release/eyeray

command -v povray >/dev/null || { echo "povray.sh: POV-Ray is missing: apt-get install povray" >&2; exit 1; }
[ -x "$eyeray" ] || { echo "povray.sh: $eyeray is missing: build it first" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

runEyeray() { "$eyeray" render homage --samples 1 --threads 2 --quiet --width "$1" --height "$2" -o "$work/eyeray.png"; }
runPovray() {
  povray "+I$root/tests/bench/homage.pov" "+O$work/povray.png" "+W$1" "+H$2" +WT2 -D -A -GA +FN8 >/dev/null 2>"$work/log" ||
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

for _ in $(seq "$repetitions"); do
  for program in Eyeray Povray; do
    measure "$work/$program.start" "run$program" 1 1
    measure "$work/$program.whole" "run$program" 1280 720
  done
done

echo "homage, 1280x720, depth 5, one sample, 2 threads; medians of $repetitions runs in turn; load $(cut -d' ' -f1 /proc/loadavg)"
for column in 1 2; do
  awk -v what="$([ $column = 1 ] && echo wall || echo CPU)" \
    -v e="$(median "$work/Eyeray.whole" $column)" -v e0="$(median "$work/Eyeray.start" $column)" \
    -v p="$(median "$work/Povray.whole" $column)" -v p0="$(median "$work/Povray.start" $column)" \
    'BEGIN {
      printf "%-4s  Eyeray %.3f s (start-up %.3f)   POV-Ray %.3f s (start-up %.3f)   ", what, e, e0, p, p0
      printf "POV-Ray / Eyeray: %.1f whole, %.1f without start-up\n", p / e, (p - p0) / (e - e0)
    }'
done
if [ -n "$pictures" ]; then
  mkdir -p "$pictures"
  cp "$work/eyeray.png" "$work/povray.png" "$pictures"
fi
