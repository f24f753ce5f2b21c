#!/bin/bash
# Instructions a ray by scene, index and kind of ray, counted by valgrind (apt-get install valgrind), which knows
# no AVX-512: the last line says what ran. The rays are sent once and twice, and the difference counts.
# usage: tests/bench/instructions.sh [SCENE...]
set -euo pipefail
bench=$(realpath "$(dirname "$0")/../../build/release/eyeray_instructions_bench")
[ $# -gt 0 ] || set -- homage many knot
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

count() { # instructions of a whole run
    valgrind --tool=callgrind --callgrind-out-file=counts "$bench" "$@" > answer 2> messages || { cat messages >&2; exit 1; }
    awk '/Collected/ { print $NF }' messages
}

printf '%-10s %-6s %9s %9s %9s %9s\n' scene index eye shadow mirror diffuse
for scene; do
    for index in brute bvh2 bvh8; do
        [ "$index" = brute ] && [ "$scene" != homage ] && continue # slow where there are thousands
        printf '%-10s %-6s' "$scene" "$index"
        for kind in eye shadow reflection diffuse; do
            once=$(count "$scene" "$index" "$kind" 1)
            twice=$(count "$scene" "$index" "$kind" 2)
            printf ' %9d' $(((twice - once) / $(cut -d' ' -f1 answer)))
        done
        echo
    done
done
echo "rays one by one, by $(cut -d' ' -f2 answer)"
