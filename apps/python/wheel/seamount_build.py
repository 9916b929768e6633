"""What pip calls to build the module (PEP 517): the checkout's own build, and the package with recipes, data and networks as
a wheel. Needs nothing but the packages of packages/run.txt and packages/python.txt."""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PLAIN = (".py", ".typed")
SHARED = ("recipes", "data", "models")
CONFIGURE = """
source tools/setup.sh
install_packages run python || exit
settings=(-DSEAMOUNT_PYTHON:BOOL=ON)
[[ -e build/dev/build.ninja ]] || settings+=(-DSEAMOUNT_TESTS:BOOL=OFF)
configure dev "${settings[@]}" && build dev seamount_python_types
"""
# Another Python than the system's has a build of its own: the module is of one version.
CONFIGURE_OTHER = """
source tools/setup.sh
install_packages run python || exit
cmake --preset dev -B "build/$1" -DSEAMOUNT_PYTHON=ON -DSEAMOUNT_TESTS=OFF -DPython_EXECUTABLE="$2" >&2 || exit
build "$1" seamount_python_types
"""


def version():
    return re.search(r'kVersion = "([\d.]+)"', (ROOT / "src/seamount/base/version.h").read_text())[1]


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-" + re.sub(r"[.-]", "_", sysconfig.get_platform())


def is_systems():
    system = pathlib.Path("/usr/bin/python3")
    asked = [str(system), "-c", "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"]
    same = system.exists() and subprocess.run(asked, text=True, stdout=subprocess.PIPE).stdout.strip()
    return not system.exists() or same == sysconfig.get_config_var("EXT_SUFFIX")


def built_package():
    """The folder of the package, built."""
    name = "dev" if is_systems() else "python-" + sysconfig.get_config_var("SOABI")
    script = CONFIGURE if name == "dev" else CONFIGURE_OTHER
    subprocess.run(["bash", "-c", script, "build", name, sys.executable], cwd=ROOT, check=True)
    return ROOT / "build" / name / "apps/python/seamount"


def files_of(package):
    """(name in the wheel, file) of all that is installed: the module and its types as they were built, the rest as it is in
    the checkout."""
    for made in ("_core*" + sysconfig.get_config_var("EXT_SUFFIX"), "*.pyi"):
        yield from ((f"seamount/{path.name}", path) for path in sorted(package.glob(made)))
    sources = ROOT / "apps/python/seamount"
    yield from ((f"seamount/{path.name}", path) for path in sorted(sources.iterdir()) if path.suffix in PLAIN)
    for folder in SHARED:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_file() and not path.name.endswith(".critic.safetensors"):
                yield f"seamount/share/{path.relative_to(ROOT).as_posix()}", path


def metadata():
    return f"""Metadata-Version: 2.1
Name: seamount
Version: {version()}
Summary: Terrain authoring, from ridgeline to reef
Requires-Python: >=3.9
Requires-Dist: numpy
"""


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = built_package()
    info = f"seamount-{version()}.dist-info"
    kind = f"Wheel-Version: 1.0\nGenerator: seamount\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    texts = {f"{info}/METADATA": metadata(), f"{info}/WHEEL": kind}
    contents = {name: path.read_bytes() for name, path in files_of(package)}
    contents |= {name: text.encode() for name, text in texts.items()}
    rows = []
    for name, content in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.append(f"{name},sha256={digest},{len(content)}\n")
    contents[f"{info}/RECORD"] = "".join([*rows, f"{info}/RECORD,,\n"]).encode()
    made = f"seamount-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory, made), "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, content in contents.items():
            wheel.writestr(zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)
    return made


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("the module is installed from a checkout: pip install PATH")
