#!/usr/bin/env python3
"""The pass graph of real packs: the JSON follows its schema, Graphviz reads the .dot, and the picture
is one. graph_test.py PROGRAM SOURCE_DIR; 77 (skipped) without jsonschema or Graphviz."""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)
if shutil.which("dot") is None:
    print("skipped: Graphviz is not installed")
    sys.exit(77)

program, source = sys.argv[1], Path(sys.argv[2])
schema = json.loads((source / "docs/pass-graph.schema.json").read_text())

# A name of the pack that HTML labels, tables and strings must not take for their own.
HOSTILE = {
    "shaders.properties": 'iris.features.required=CUSTOM_IMAGES\n'
                          'image.a"<|>&b=none RGBA RGBA8 UNSIGNED_BYTE false false 4 4\n'
                          'customTexture.<b>|"x"=tex.png\n',
    "final.fsh": "#version 330 compatibility\nuniform sampler2D colortex0;\nvoid main() { "
                 "gl_FragColor = texture2D(colortex0, vec2(0.5)); }\n",
}


def graph(pack, path):
    subprocess.run([program, "options", pack, "--quiet", "--graph", path], check=True)
    return path


def check(pack, folder):
    data = json.loads(graph(pack, folder / "graph.json").read_text())
    jsonschema.validate(data, schema)
    names = [one["name"] for one in data["passes"]]
    assert len(names) == len(set(names)), "pass names are not unique"
    for one in data["passes"]:
        for read in one["reads"]:
            assert set(read["from"]) <= set(names), f"{one['name']} reads from an unknown pass"
    subprocess.run(["dot", "-Tcanon", graph(pack, folder / "graph.dot")], check=True,
                   stdout=subprocess.DEVNULL)
    svg = graph(pack, folder / "graph.svg").read_text()
    assert "</svg>" in svg, "no SVG"
    assert graph(pack, folder / "graph.png").read_bytes().startswith(b"\x89PNG"), "no PNG"
    return names


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    names = check(source / "shaderpack", folder)
    assert "final" in names and "gbuffers_terrain" in names, names
    hostile = folder / "hostile" / "shaders"
    hostile.mkdir(parents=True)
    for file, text in HOSTILE.items():
        (hostile / file).write_text(text)
    check(folder / "hostile", folder)
