#!/bin/sh
# The pictures of README.md, made with the reference pack: docs/gallery/make.sh [ORRIS]
set -eu
cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.."
orris=${1:-build/release/orris}
picture() {
  name=$1 world=$2
  shift 2
  "$orris" render shaderpack "worlds/$world" -o "docs/gallery/$name.png" --frames 160 "$@"
}
picture day village --camera street --size 800x450
picture night village --camera street --time 18000 --size 480x270
picture cave lava_cave --camera lava --size 480x270
picture chapel chapel --camera nave --size 480x270
