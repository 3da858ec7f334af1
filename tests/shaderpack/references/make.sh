#!/bin/sh
# Traces the stored references of reference_gl_test.cpp anew: make.sh PROGRAM. Only where a scene or what the pack
# means has changed on purpose; the pictures are part of the test.
set -eu
cd "$(dirname "$0")/../../.."
trace() {
  "$1" trace "worlds/$2" --camera "$3" --bounces "$4" -o "$5" --size 16x9 --noise 0.004 --seconds 30 \
    --seed 7 --set AMBIENT_MINIMUM=0.0 DIRECT_LIGHT=NONE
  rm -f "$5.trace"
}
folder=tests/shaderpack/references
for view in h4_house:inside deep_hall:mouth bend_grey:lit lava_cave:water chapel:nave; do
  trace "$1" "${view%:*}" "${view#*:}" 4096 "$folder/${view%:*}.exr"
done
for bounces in 1 2 4; do
  trace "$1" h4_house inside "$bounces" "$folder/h4_house_$bounces.exr"
done
