#!/usr/bin/env python3
"""The pictures of docs/pictures.md: docs/gallery/packs.py ORRIS PACK... [--only SCENE...]

Scenes are worlds of the project with other weather, light, hands and entities. Each becomes one picture, the packs side
by side in the order given. Needs ImageMagick (Debian: imagemagick), which nothing else of Orris does.
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FRAMES = "auto:128"
SIZE = "320x180"
STORM = {"rain": 1, "thunder": 1}

# Scene: the world, its camera, what its environment gets, what its world gets.
SCENES = {
    "rain": ("terrain", "shore", {"time": 4000, "rain": 1}, {}),
    "snow": ("snow_hut", "outside", {"time": 5000, "rain": 1, "temperature": 0.0}, {}),
    "night": ("village", "street", {"time": 18000}, {}),
    "lightning": ("terrain", "shore", {"time": 11000, **STORM},
                  {"events": [{"frame": 0, "lightning": {"at": [44, 70, 50], "frames": 1000}}]}),
    "torch": ("bay", "shore", {"time": 18000, "player": {"mainHand": "torch", "hideGui": False}}, {}),
    "glint": ("everything", {"name": "glint", "position": [12.0, 3.7, 10.2], "target": [12.3, 3.0, 6]},
              {"time": 4000, "rain": 0, "player": {}},
              {"events": [], "entities": [
                  {"kind": "armor_stand", "position": [12.9, 2, 6.2], "yaw": 12, "glint": True},
                  {"kind": "armor_stand", "position": [11.2, 2, 6.2], "yaw": -12}]}),
}


def write_world(folder, scene):
    """The folder of a scene's world, and the name of its camera."""
    name, camera, environment, more = SCENES[scene]
    world = json.loads((ROOT / "worlds" / name / "world.json").read_text())
    world.setdefault("environment", {}).update(environment)
    world.update(more)
    if not isinstance(camera, str):
        world["cameras"].append(camera)
        camera = camera["name"]
    folder = Path(folder) / scene
    folder.mkdir()
    (folder / "world.json").write_text(json.dumps(world))
    return folder, camera


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("orris")
    parser.add_argument("packs", nargs="+", metavar="PACK")
    parser.add_argument("--only", choices=SCENES, nargs="+", default=list(SCENES))
    parser.add_argument("--out", type=Path, default=ROOT / "docs/gallery/packs")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for scene in args.only:
            world, camera = write_world(folder, scene)
            pictures = [Path(folder) / f"{scene}{i}.png" for i in range(len(args.packs))]
            for pack, picture in zip(args.packs, pictures):
                subprocess.run([args.orris, "render", pack, world, "--camera", camera, "--size", SIZE, "--frames", FRAMES,
                                "-o", picture], check=True)
            subprocess.run(["convert", *pictures, "+append", "-quality", "84", args.out / f"{scene}.jpg"], check=True)


if __name__ == "__main__":
    main()
