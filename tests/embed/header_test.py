"""Header, page and library name the same functions: header_test.py LIBRARY SOURCE"""
import pathlib
import re
import subprocess
import sys

LIBRARY, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
header = (SOURCE / "loader/api/include/orris/orris.h").read_text()
page = (SOURCE / "docs/embedding.md").read_text()

declared = set(re.findall(r"^ORRIS_API [^;]*?\b(orris_\w+)\(", header, re.M))
exported = set(re.findall(r" [A-Z] (\w+)", subprocess.run(
    ["nm", "-D", "--defined-only", LIBRARY], capture_output=True, text=True, check=True).stdout))
missing = sorted(name for name in declared if f"`{name}`" not in page)
problems = []
if declared != exported:
    problems.append(f"exported and declared differ in {sorted(declared ^ exported)}")
if missing:
    problems.append(f"docs/embedding.md lacks {missing}")
for text in re.findall(r"\bORRIS_KIND_(\w+) = \d+", header):
    if text != "COUNT" and f"`{text}`" not in page:
        problems.append(f"docs/embedding.md lacks the kind {text}")
if len(declared) < 30:
    problems.append(f"only {len(declared)} functions are read from the header")
sys.exit("\n".join(problems) or 0)
