"""Meshes: gltf-validator, assimp and Blender."""

import json

from bench import needs

VALIDATE = """
const validator = require('gltf-validator'), fs = require('fs');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])), {maxIssues: 20}).then(
  report => console.log(JSON.stringify(report.issues)));
"""


def check_glb_is_valid(bench):
    env = bench.node_module("gltf-validator")
    bench.path("validate.js").write_text(VALIDATE)
    bench.seamount("convert", bench.island(), "island.glb", "--set", "max_triangles=20000", "--set", "texture_px=256")
    issues = json.loads(bench.run("node", "validate.js", "island.glb", env=env))
    assert issues["numErrors"] == 0 and issues["numWarnings"] == 0, issues


@needs("assimp")
def check_assimp_reads_all_formats(bench):
    island = bench.island()
    for kind in ("glb", "obj", "ply", "stl"):
        bench.seamount("convert", island, f"island.{kind}", "--set", "max_triangles=20000", "--set", "texture_px=0")
        assert "Faces" in bench.run("assimp", "info", f"island.{kind}")
