#!/usr/bin/env python3
"""package_test.py BUILD_DIR: makes the Debian package, reads what it says and holds, unpacks it and
runs the command from there. Exit status 77: a tool is missing."""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

EXPECTED = ["./usr/bin/orris", "./usr/lib/orris/orris-image-codecs.so",
            "./usr/share/man/man1/orris.1.gz",
            "./usr/share/bash-completion/completions/orris", "./usr/share/doc/orris/copyright",
            "./usr/share/doc/orris/changelog.gz", "./usr/share/doc/orris/checks.md",
            "./usr/share/doc/orris/ci.md", "./usr/share/doc/orris/schema/validate.schema.json",
            "./usr/share/orris/shaderpack/shaders/shaders.properties",
            "./usr/share/orris/worlds/cornell/world.json"]


def output_of(*words, status=0, **more):
    result = subprocess.run([str(word) for word in words], text=True, capture_output=True, **more)
    assert result.returncode == status, (words, result.returncode, result.stdout, result.stderr)
    return result.stdout


def check_control(package, homepage):
    fields = dict(re.findall(r"^ (\S+): (.*)$", output_of("dpkg-deb", "-I", package), re.M))
    assert fields["Package"] == "orris", fields
    depends = fields["Depends"]
    for library in ("libc6", "libfmt", "libopenimageio", "libzip", "libglfw3", "libosmesa6"):
        assert re.search(rf"\b{library}", depends), (library, depends)
    assert "graphviz" in fields["Recommends"], fields
    assert fields["Maintainer"] and fields["Section"] == "graphics", fields
    assert fields.get("Homepage", "") == homepage, fields  # nobody publishes a build without an address
    return fields


def check_contents(package):
    rows = [line.split(maxsplit=5) for line in output_of("dpkg-deb", "-c", package).splitlines()]
    paths = {row[5]: row for row in rows}
    missing = [path for path in EXPECTED if path not in paths]
    assert not missing, f"not in the package: {missing}"
    strange = [path for path in paths if re.search(r"\.(a|h|cmake|cpp|o)$|__pycache__", path)]
    assert not strange, f"in the package: {strange}"
    for path, row in paths.items():
        mode = "drwxr-xr-x" if path.endswith("/") else \
            "-rwxr-xr-x" if path.startswith("./usr/bin/") else "-rw-r--r--"
        assert row[0] == mode and row[1] == "root/root", row


def check_command(package, folder, version):
    output_of("dpkg-deb", "-x", package, folder / "root")
    share = folder / "root/usr/share/orris"
    program = folder / "root/usr/bin/orris"
    assert output_of(program, "--version").strip() == f"orris {version}"
    text = output_of(program, "validate", share / "shaderpack", cwd=folder)
    good, all_ = re.search(r"(\d+)/(\d+) programs", text).groups()
    assert good == all_ != "0", text
    assert "cornell" in output_of(program, "world", share / "worlds/cornell")


def run_lintian(package):
    if not shutil.which("lintian"):
        return print("lintian is not installed: not run")
    errors = [line for line in output_of("lintian", "--fail-on", "none", package).splitlines()
              if line.startswith("E: ")]
    assert not errors, "\n".join(errors)


def main():
    build = Path(sys.argv[1])
    needed = [tool for tool in ("cpack", "dpkg-deb", "dpkg-shlibdeps", "nm") if not shutil.which(tool)]
    if needed:
        print("skipped, not installed:", *needed)
        return 77
    homepage = re.search(r"^ORRIS_HOMEPAGE:STRING=(.*)$", (build / "CMakeCache.txt").read_text(), re.M)[1]
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        output_of("cpack", "-G", "DEB", "-B", folder, "--config", build / "CPackConfig.cmake")
        packages = list(folder.glob("*.deb"))
        assert len(packages) == 1, packages
        fields = check_control(packages[0], homepage)
        check_contents(packages[0])
        check_command(packages[0], folder, fields["Version"])
        run_lintian(packages[0])
        print(packages[0].name, f"{packages[0].stat().st_size / 1e6:.1f} MB", fields["Depends"])
    return 0


if __name__ == "__main__":
    sys.exit(main())
