#!/usr/bin/env python3
"""Makes the Debian packages, looks at what they say and depend on, and uses what they hold where no file of the checkout can be
seen: recipes, networks, the studio's page, the Python module, the library's package file for CMake. Nothing is installed."""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[1]
# The packages, with the list of packages/ that holds what each may depend on, and a file that each brings.
PACKAGES = {"seamount": ("run", "bin/seamount"), "libseamount-dev": ("run", "include/seamount/ops/island/build.h"),
            "python3-seamount": ("python", "lib/python3/dist-packages/seamount/__init__.py"),
            "seamount-training": ("test", "lib/seamount/seamount_training.so"),
            "seamount-ranks": ("test", "lib/seamount/seamount_ranks.so")}
HIDDEN = ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", 'mount -t tmpfs none "$0" && exec "$@"', str(ROOT)]
USE_PYTHON = """
import seamount as sm
isle = sm.island.build(domain=sm.Frame(64, 64, 200), seed=1)
assert sm.learned.island(isle.labels, domain=isle.terrain).array.max() > 0
recipe = sm.Recipe.example("kauai", cache=False)
recipe.set("/domain/cell_m", 800)
assert recipe.value("reef").array.max() > 100
"""


def output(*command, **options):
    return subprocess.run(list(map(str, command)), check=True, text=True, stdout=subprocess.PIPE, **options).stdout


def check_control(package, field):
    """What a package says of itself, and that packages/*.txt bring all that it depends on."""
    sys.path.insert(0, str(ROOT / "tools"))
    import check_packages
    purpose = PACKAGES[package][0]
    purposes = {"run": ["run"], "python": ["run", "python"], "test": ["run", "test"]}[purpose]
    debian = check_packages.Debian()
    allowed = debian.base | debian.closure([name for each in purposes for name in check_packages.listed(each)]) | set(PACKAGES)
    depends = [debian.names(either, "|")[0] for either in field["Depends"].split(",")]
    assert "libc6" in depends or package == "libseamount-dev", depends
    assert set(depends) <= allowed, f"{package}: packages/{purpose}.txt does not bring {set(depends) - allowed}"
    version = re.search(r'kVersion = "([\d.]+)"', (ROOT / "src/seamount/base/version.h").read_text())[1]
    assert field["Version"] == version, field["Version"]
    summary, *more = field["Description"].splitlines()
    assert len(summary) < 80 and len(more) >= 2, field["Description"]


def fields_of(deb):
    field = {}
    for name, value in re.findall(r"^([\w-]+): (.*(?:\n .*)*)", output("dpkg-deb", "-f", deb), re.MULTILINE):
        field[name] = value
    return field


def check_program(usr, folder):
    """The installed program, run where the checkout cannot be seen."""
    seamount = usr / "bin/seamount"
    said = output(*HIDDEN, seamount, "--version")
    places = {line.split()[0]: line.split()[1] for line in said.splitlines()[1:]}
    for kind in ("models", "recipes", "data"):
        assert places[kind] == f"{usr}/share/seamount/{kind}", said
    assert str(ROOT) not in said, said
    for recipe in ("island", "kauai"):  # kauai reads the data beside the recipes
        files = output(*HIDDEN, seamount, "run", usr / f"share/seamount/recipes/{recipe}.json", "--size", "128", "--no-cache", "--out",
                       folder / recipe, stderr=subprocess.DEVNULL).split()
        assert files and all((folder / file).is_file() for file in files), files
    learn = [*HIDDEN, seamount, "learned.island", "--labels", usr / "share/seamount/data/painted_island.png", "--no-cache", "--out"]
    subprocess.run([*learn, folder / "learned"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    # Its networks are its own: without them it says where it looked, which is nowhere in the checkout.
    (usr / "share/seamount/models").rename(folder / "aside")
    failed = subprocess.run([seamount, *learn[len(HIDDEN) + 1:], folder / "none"], text=True, stderr=subprocess.PIPE)
    (folder / "aside").rename(usr / "share/seamount/models")
    assert failed.returncode != 0 and f"{usr}/share/seamount/models" in failed.stderr, failed.stderr
    assert str(ROOT) not in failed.stderr, failed.stderr


def check_studio(usr, folder):
    """The studio hands out the page that is installed; where none was built, it says so."""
    command = [*HIDDEN, str(usr / "bin/seamount"), "studio", "--folder", str(folder), "--state", str(folder / "state"), "--no-browser",
               "--no-cache"]
    has_page = (usr / "share/seamount/studio/index.html").is_file()
    assert has_page == (ROOT / "studio/dist/page/index.html").is_file()
    with subprocess.Popen(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        address = process.stdout.readline().strip()
        try:
            if not has_page:
                assert "page is not built" in process.stderr.read()
                return
            page = urllib.request.urlopen(address.split("#")[0], timeout=20).read().decode()
            assert page == (usr / "share/seamount/studio/index.html").read_text(), page
            assert (usr / "share/seamount/studio/licences.txt").is_file()
        finally:
            process.terminate()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="the build folder")
    parser.add_argument("--python", default="/usr/bin/python3", help="the Python that the module was built for")
    arguments = parser.parse_args()
    if not all(map(shutil.which, ("dpkg-deb", "dpkg-shlibdeps", "unshare"))) or subprocess.run([*HIDDEN, "true"]).returncode:
        print("skipped: not Debian, or this user may hide no folder")
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        output("cpack", "-G", "DEB", "-B", folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none", cwd=arguments.build)
        debs = {fields_of(deb)["Package"]: deb for deb in folder.glob("*.deb")}
        assert {"seamount", "libseamount-dev", "python3-seamount"} <= set(debs) <= set(PACKAGES), debs
        usr = folder / "root/usr"
        for package, deb in debs.items():
            check_control(package, fields_of(deb))
            output("dpkg-deb", "-x", deb, folder / "root")
            assert (usr / f"share/doc/{package}/copyright").is_file() and (usr / PACKAGES[package][1]).is_file(), package
        check_program(usr, folder)
        check_studio(usr, folder)
        environment = {name: value for name, value in os.environ.items() if name != "SEAMOUNT_MODELS"}
        environment["PYTHONPATH"] = str(usr / "lib/python3/dist-packages")
        output(*HIDDEN, arguments.python, "-B", "-c", USE_PYTHON, env=environment, cwd=folder)
        output("cmake", "-S", ROOT / "examples", "-B", folder / "examples", f"-DCMAKE_PREFIX_PATH={usr}")
        print(json.dumps({package: deb.stat().st_size for package, deb in debs.items()}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
