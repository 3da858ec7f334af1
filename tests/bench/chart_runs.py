"""What the charts of docs/ share: frame times by `orris chart`, in turns and by processor time."""

import csv
import pathlib
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent


def run_chart(orris, pack, world, folder, axes, size="160x90", camera="", settings=(), baseline="", reference="",
              rounds=4, visit=2, seconds=0, more=()):
    """`orris chart` by processor time; the same call on the same folder goes on where it ended. `seconds`: end after so
    long, 0 for never; `more`: flags."""
    subprocess.run([orris, "chart", pack, world, "-o", folder, "--size", size,
                    *(["--camera", camera] if camera else []), "--set", *settings,
                    *[word for axis in axes for word in ("--axis", axis)],
                    *(["--baseline", baseline] if baseline else []), "--reference", reference or baseline,
                    "--reference-frames", "2", "--warm-up", "2", "--frames", "2", "--visit", str(visit),
                    "--rounds", str(rounds), *(["--budget", f"{seconds:.0f}s"] if seconds else []),
                    "--clock", "cpu", "--quiet", *more], check=True)


def rows_of(folder, table):
    """Of a table that a chart wrote; none where it did not come to that."""
    path = pathlib.Path(folder) / table
    if not path.exists():
        return []
    with path.open() as file:
        return list(csv.DictReader(file))


def frame_times(orris, pack, world, folder, axes, **how):
    """Milliseconds of processor time by setting."""
    run_chart(orris, pack, world, folder, axes, **how)
    return {row["setting"]: float(row["ms"]) for row in rows_of(folder, "settings.csv")}


def pass_times(folder):
    """Milliseconds of processor time by setting and pass, of a chart that was run."""
    times = {}
    for row in rows_of(folder, "passes.csv"):
        times.setdefault(row["setting"], {})[row["pass"]] = float(row["ms"])
    return times


def lamp_field(count, folder, turn=0):
    """The world of so many lamps, made where it is not there."""
    world = folder / (f"lamps{count}" + (f"-turn{turn}" if turn else ""))
    if not world.exists():
        subprocess.run([SOURCE / "worlds/lamp_field.py", str(count), world, "--turn", str(turn)], check=True)
    return world
