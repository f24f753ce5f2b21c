#!/bin/bash
# What `eyeray needs --apply` saves on each built-in scene: CPU seconds of rendering as set, as the viewer does,
# and of the scene with no more than it needs; and mean FLIP between the two pictures.
# usage: tests/bench/needs.sh [WIDTH] [EYERAY]
set -euo pipefail
width=${1:-1280}
eyeray=$(realpath "${2:-$(dirname "$0")/../../build/release/eyeray}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
TIMEFORMAT='%U'

cpu() { { time "$@" > /dev/null 2> messages; } 2>&1 || { cat messages >&2; exit 1; }; }

printf '%-14s %9s %9s %7s %8s\n' scene 'as set/s' 'needed/s' faster FLIP
"$eyeray" scenes | awk '$1 !~ /^lab-/ { print $1 }' | while read -r scene; do
    "$eyeray" needs "$scene" --apply -o needed.gltf --width "$width" --quiet > table
    # 256 samples, or fewer if no error is left that a screen could show: 0.5 / 255
    as_set=$(cpu "$eyeray" render "$scene" -o as_set.png --width "$width" --samples 256 --error 0.00196)
    needed=$(cpu "$eyeray" render needed.gltf -o needed.png --width "$width")
    flip=$("$eyeray" compare as_set.png needed.png | awk '$1 == "flip" { print $2 }')
    awk -v s="$scene" -v a="$as_set" -v n="$needed" -v f="$flip" \
        'BEGIN { printf "%-14s %9.2f %9.2f %7.1f %8.4f\n", s, a, n, a / n, f }' | tee -a rows
done
sort -k4,4n rows | awk '{ faster[NR] = $4; if ($5 > worst) worst = $5 }
    END { middle = (faster[int((NR + 1) / 2)] + faster[int(NR / 2) + 1]) / 2
          printf "median %.1f times faster (goal 2), largest FLIP %.4f (goal 0.005): %s\n", middle, worst,
                 (middle >= 2 && worst < 0.005) ? "met" : "not met" }'
