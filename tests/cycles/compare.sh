#!/usr/bin/env bash
# Holds path tracing against Blender's Cycles, on the box of `cornell` or the balls of `homage`: both pictures differ by no
# more than their own noise; and which is nearer to the truth after the same time. Says so and does nothing where Blender
# is missing.
# usage: tests/cycles/compare.sh [cornell|homage] [SECONDS for the second half] [FOLDER for the pictures]
set -euo pipefail
scene=${1:-cornell} seconds=${2:-10}
# Depths that leave nothing behind: with a smooth surface at the last one, Cycles still adds the sky and Eyeray does not.
case $scene in
  cornell) width=160 height=120 depth=8 ;;
  homage) width=160 height=90 depth=16 ;;
  *) echo "compare.sh: $scene: unknown: cornell or homage" >&2; exit 2 ;;
esac
threads=2 many=64
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
eyeray=$root/build/release/eyeray
command -v blender >/dev/null || { echo "compare.sh: skipped: Blender is missing (apt-get install blender)"; exit 0; }
[ -x "$eyeray" ] || { echo "compare.sh: $eyeray is missing: build it first" >&2; exit 1; }
work=${3:-$(mktemp -d)}
mkdir -p "$work"
[ -n "${3:-}" ] || trap 'rm -rf "$work"' EXIT

# Pictures OUT of so many samples or seconds (0: no limit), with this seed.
byEyeray() { # OUT SAMPLES SECONDS SEED
  local stop=(--samples "$2")
  [ "$3" = 0 ] || stop+=(--seconds "$3")
  "$eyeray" render "$scene" --method path --max-depth $depth --width $width --height $height --threads $threads \
    --seed "$4" "${stop[@]}" --stats "$work/stats.json" --quiet -o "$1"
}
byCycles() {
  blender -b --factory-startup --python "$here/render.py" -- "$root/assets/scenes/$scene.gltf" "$1" $width $height \
    $depth "$2" "$3" "$4" $threads >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  [ -s "$1" ] || { cat "$work/log" >&2; exit 1; }
}
rmse() { "$eyeray" compare "$1" "$2" --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["rmse"])'; }

for seed in 1 2; do
  byEyeray "$work/eyeray$seed.exr" $many 0 $seed
  byCycles "$work/cycles$seed.exr" $many 0 $seed
done
python3 - "$(rmse "$work/eyeray1.exr" "$work/eyeray2.exr")" "$(rmse "$work/cycles1.exr" "$work/cycles2.exr")" \
  "$(rmse "$work/eyeray1.exr" "$work/cycles1.exr")" $many <<'END'
import sys
eyeray, cycles, between, many = map(float, sys.argv[1:])
expected = ((eyeray**2 + cycles**2) / 2) ** 0.5
print(f"{many:.0f} samples: noise of Eyeray {eyeray / 2**0.5:.5f}, of Cycles {cycles / 2**0.5:.5f};", end=" ")
print(f"they differ by {between:.5f}, their noise alone by {expected:.5f}")
if between > 1.1 * expected:
    sys.exit("compare.sh: they differ by more than their noise")
END

# The truth: both programs' pictures of many samples, as far as they have them; each is held against the other's.
byEyeray "$work/eyeray.exr" $((64 * many)) 0 3
byCycles "$work/cycles.exr" $((64 * many)) 0 3
byEyeray "$work/eyeray-timed.exr" 1000000 "$seconds" 4
byCycles "$work/cycles-timed.exr" 1000000 "$seconds" 4
echo "after $seconds s on $threads threads, RMSE against the other's $((64 * many)) samples:" \
  "Eyeray $(rmse "$work/cycles.exr" "$work/eyeray-timed.exr"), Cycles $(rmse "$work/eyeray.exr" "$work/cycles-timed.exr")"
