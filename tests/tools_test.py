#!/usr/bin/env python3
"""Tests of the gates themselves: each must fail when it should."""

import pathlib
import stat
import sys
import tempfile
import unittest
from pathlib import PurePath

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests/cli")]
sys.dont_write_bytecode = True

import check_layers
import check_packages
import run_cases
import tidy


class Layers(unittest.TestCase):
    def check(self, file, include, allowed):
        quote = "<" if include.endswith(">") else '"'
        why = check_layers.problem(PurePath(file), quote, include if quote == "<" else include + '"')
        self.assertEqual(why is None, allowed, why)

    def test_table(self):
        self.check("model/grid.h", "seamount/base/error.h", True)
        self.check("base/text.cpp", "seamount/model/grid.h", False)
        self.check("io/raster.cpp", "seamount/geom/scalar/noise.h", False)
        self.check("ops/reef/grow.cpp", "seamount/geom/scalar/noise.h", True)
        self.check("ops/reef/grow.cpp", "seamount/recipe/registry.h", False)
        self.check("recipe/registry.cpp", "seamount/ops/reef/grow.h", True)
        self.check("server/handlers.cpp", "seamount/train/dataset.h", False)
        self.check("extra/new.cpp", "seamount/base/error.h", False)

    def test_families(self):
        self.check("ops/reef/grow.cpp", "seamount/ops/reef/flow.h", True)
        self.check("ops/reef/grow.cpp", "seamount/ops/island/build.h", False)
        self.check("ops/contour/growth/grow_test.cpp", "seamount/ops/hydrology/fill.h", True)

        self.check("ops/reef/growth/walk.cpp", "seamount/ops/island/build.h", False)
        self.check("ops/reef/growth/walk.cpp", "seamount/ops/reef/grow.h", True)

    def test_rooms(self):
        self.check("geom/water/flow.cpp", "seamount/geom/grid/resample.h", True)
        self.check("geom/grid/resample.cpp", "seamount/geom/water/flow.h", False)
        self.check("geom/grid/resample_test.cpp", "seamount/geom/water/flow.h", True)
        self.check("geom/attic/old.cpp", "seamount/geom/grid/resample.h", False)
        self.check("ops/contour/growth/grow.cpp", "seamount/ops/contour/edit/edit.h", False)
        self.check("ops/contour/edit/edit.cpp", "seamount/ops/contour/growth/grow.h", True)

    def test_libraries(self):
        self.check("ops/reef/grow.cpp", "nlohmann/json.hpp>", False)
        self.check("io/vector.cpp", "nlohmann/json.hpp>", True)
        self.check("geom/scalar/noise.cpp", "thread>", False)
        self.check("ops/learned/network.cpp", "dnnl.hpp>", True)
        self.check("ops/amplify/sparse.cpp", "dnnl.hpp>", False)

    def test_short_paths(self):
        self.check("model/grid.h", "drawn.h", False)

    def test_whole_tree(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "src/seamount/base/text.cpp")
            file.parent.mkdir(parents=True)
            file.write_text('#include "seamount/base/text.h"\n')
            self.assertEqual(check_layers.main(folder), 0)
            file.write_text('#include "seamount/io/raster.h"\n')
            self.assertEqual(check_layers.main(folder), 1)


    def test_a_source_includes_its_own_header_first(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "src/seamount/base/text.cpp")
            source.parent.mkdir(parents=True)
            source.with_suffix(".h").write_text("")
            source.write_text('#include <string>\n#include "seamount/base/text.h"\n')
            self.assertEqual(check_layers.main(folder), 1)
            source.write_text('#include "seamount/base/text.h"\n#include <string>\n')
            self.assertEqual(check_layers.main(folder), 0)


class Packages(unittest.TestCase):
    def test_commands_of_a_script(self):
        script = """# comment: find nothing here
cd "$(dirname "$0")" && exec nice -n 5 ninja "$@"
found=$(grep -c 'sed awk' file) || { echo "cp mv"; exit 1; }
find . -print0 |
  xargs -0 -n 16 -P "$(nproc)" clang-format-14 "${action[@]}"
for file in a b; do if cmp a b; then LC_ALL=C sort a; fi; done
"""
        words = check_packages.commands_of(script)
        for command in ("dirname", "ninja", "grep", "find", "clang-format-14", "cmp", "sort"):
            self.assertIn(command, words)
        for word in ("comment", "file", "awk", "cp", "mv"):
            self.assertNotIn(word, words)

    @unittest.skipUnless(check_packages.INFO.exists(), "not Debian")
    def test_owners_and_what_follows_from_a_package(self):
        debian = check_packages.Debian()
        self.assertIn("dpkg", debian.owner("/usr/bin/dpkg"))
        self.assertEqual(debian.owner("/usr/include/of_nobody.h"), set())
        self.assertIn("libc6", debian.closure(["dpkg"]))
        self.assertNotIn("libgmock-dev", debian.closure(["libgtest-dev"]))
        self.assertIn("coreutils", debian.base)


class Tidy(unittest.TestCase):
    def test_a_source_is_looked_at_again_when_a_header_changes(self):
        with tempfile.TemporaryDirectory() as folder:
            source, header = pathlib.Path(folder, "a.cpp"), pathlib.Path(folder, "a.h")
            source.write_text('#include "a.h"\n')
            header.write_text('#include "b.h"\n')
            self.assertEqual(tidy.reached(source, set(), pathlib.Path(folder)), {source, header})


class Cases(unittest.TestCase):
    def replay(self, text):
        return run_cases.replay(text, "/usr/bin")

    def test_right_expectations_stay(self):
        for text in (
                "# comment\n\n$ echo a; echo b\na\nb\n\n# more\n$ true\n",
                "$ echo oops >&2; exit 3\n! oops\n? 3\n",
                "$ seq 9\n1\n...\n9\n",
                "$ echo took 12 ms\ntook [..] ms\n",
                "<<< a/b.txt\ntext\n>>>\n$ cat a/b.txt\ntext\n",
                "$ echo '# title'; echo '$ 3'\n\\# title\n\\$ 3\n",
                "$ echo 1; echo; echo 2\n1\n\n2\n\n$ pwd\n$HERE\n",
        ):
            self.assertEqual(self.replay(text), text)

    def test_wrong_expectations_are_rewritten(self):
        self.assertEqual(self.replay("$ echo b\na\n"), "$ echo b\nb\n")
        self.assertEqual(self.replay("$ exit 2\n"), "$ exit 2\n? 2\n")
        self.assertEqual(self.replay("$ true\n? 2\n"), "$ true\n")
        self.assertEqual(self.replay("$ echo silent no more >&2\n"), "$ echo silent no more >&2\n! silent no more\n")
        self.assertEqual(self.replay("$ seq 3\n1\n...\n9\n"), "$ seq 3\n1\n2\n3\n")

    def test_fitting_wildcards_survive_a_rewrite(self):
        self.assertEqual(self.replay("$ echo took 5 ms; echo b\ntook [..] ms\na\n"),
                         "$ echo took 5 ms; echo b\ntook [..] ms\nb\n")


class Executables(unittest.TestCase):
    def test_can_be_run(self):
        for name in ("run", "test", ".ci/run", "tools/format.sh", "tools/fuzz.sh", "tools/compile.sh", "tools/tidy.py",
                     "tools/check_packages.py", "tools/draw_includes.py"):
            self.assertTrue((ROOT / name).stat().st_mode & stat.S_IXUSR, name)


if __name__ == "__main__":
    unittest.main()
