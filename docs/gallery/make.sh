#!/bin/sh
# The pictures of README.md, made with the reference pack: docs/gallery/make.sh [ORRIS]
set -eu
cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.."
orris=${1:-build/release/orris}
picture() {
  name=$1 world=$2
  shift 2
  "$orris" render shaderpack "worlds/$world" -o "docs/gallery/$name.png" --size 480x270 --frames 160 "$@"
}
picture day terrain --time 3000
picture cave lava_cave --camera lava
picture chapel chapel --camera nave
