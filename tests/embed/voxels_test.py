"""The example engine's picture holds what only the engine has: voxels_test.py VOXELS SOURCE"""
import collections
import subprocess
import sys
import tempfile

VOXELS, SOURCE = sys.argv[1:]
WIDTH, HEIGHT = 320, 180


def run(pack, frames, folder):
    path = f"{folder}/picture.ppm"
    ran = subprocess.run([VOXELS, pack, path, str(frames)], capture_output=True, text=True)
    if ran.returncode == 77:
        sys.exit(77)
    return ran, path


def rows(path):
    with open(path, "rb") as file:
        if file.readline() != b"P6 %d %d 255\n" % (WIDTH, HEIGHT):
            sys.exit("another picture than was asked for")
        data = file.read()
    return [[tuple(data[(y * WIDTH + x) * 3:][:3]) for x in range(WIDTH)] for y in range(HEIGHT)]


def share(picture, wanted):
    return sum(wanted(*pixel) for row in picture for pixel in row) / (WIDTH * HEIGHT)


problems = []


def expect(true, what):
    if not true:
        problems.append(what)


with tempfile.TemporaryDirectory() as folder:
    ran, path = run(f"{SOURCE}/tests/packs/engine", 2, folder)
    expect(ran.returncode == 0 and ran.stderr == "", f"status {ran.returncode}: {ran.stderr}")
    expect(ran.stdout == "160 batches, pig drawn 2 times from the camera and 2 from the light\n", ran.stdout)
    picture = rows(path)
    # The pack paints the entity 5, which entity.properties calls a pig, red, and nothing else.
    red = [(x, y) for y in range(HEIGHT) for x in range(WIDTH) if picture[y][x] == (255, 0, 0)]
    expect(150 < len(red) < 800, f"{len(red)} pixels of the pig")
    expect(red and 130 < sum(x for x, y in red) / len(red) < 190, "the pig is not where it stands")
    sky = collections.Counter(picture[2]).most_common(1)[0]
    expect(sky[1] > WIDTH / 2 and sky[0][2] > sky[0][0], f"the sky is {sky}")
    grass = share(picture, lambda r, g, b: g > 1.3 * r and g > 1.6 * b)
    expect(grass > 0.35, f"{grass:.2f} of the picture is grass or leaves")
    water = share(picture, lambda r, g, b: b > 1.5 * r and b > 1.2 * g)
    expect(0.005 < water < 0.3, f"{water:.3f} of the picture is water")
    wrong, _ = run("/nowhere", 1, folder)
    expect(wrong.returncode == 1 and "ORRIS_ERROR_PACK" in wrong.stderr, f"no pack: {wrong.stderr}")
sys.exit("\n".join(problems) or 0)
