"""What the charts of docs/ share: frame times by `orris chart`, in turns and by processor time."""

import csv
import pathlib
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent


def frame_times(orris, pack, world, folder, axes, size="160x90", camera="", settings=(), baseline="",
                reference="", rounds=4):
    """Milliseconds of processor time by setting. The same call on the same folder goes on where it ended."""
    subprocess.run([orris, "chart", pack, world, "-o", folder, "--size", size,
                    *(["--camera", camera] if camera else []), "--set", *settings,
                    *[word for axis in axes for word in ("--axis", axis)],
                    *(["--baseline", baseline] if baseline else []), "--reference", reference or baseline,
                    "--reference-frames", "2", "--warm-up", "2", "--frames", "2", "--visit", "2",
                    "--rounds", str(rounds), "--clock", "cpu", "--quiet"], check=True)
    with (pathlib.Path(folder) / "settings.csv").open() as file:
        return {row["setting"]: float(row["ms"]) for row in csv.DictReader(file)}


def lamp_field(count, folder, turn=0):
    """The world of so many lamps, made where it is not there."""
    world = folder / (f"lamps{count}" + (f"-turn{turn}" if turn else ""))
    if not world.exists():
        subprocess.run([SOURCE / "worlds/lamp_field.py", str(count), world, "--turn", str(turn)], check=True)
    return world
