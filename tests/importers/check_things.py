"""Things: gltf-validator, Blender and assimp read models and their instances."""

import csv
import json

from bench import needs

RECIPE = {
    "seamount": 1, "domain": {"width_m": 800, "height_m": 600, "cell_m": 5}, "seed": 3,
    "steps": [
        {"id": "isle", "op": "island.build", "params": {"outlines": [220], "peak_m": 40}},
        {"id": "palms", "op": "ecosystem.scatter", "in": {"terrain": "isle.terrain"},
         "params": {"thing": {"shape": "palm"}, "spacing_m": 40, "min_height_m": 1}},
        {"id": "all", "op": "ecosystem.scatter", "in": {"terrain": "isle.terrain", "others": "palms.things"},
         "params": {"thing": {"shape": "rock", "height_m": 2}, "spacing_m": 60}}],
    "outputs": [
        {"from": "all.things", "path": "instances.glb", "texture_px": 64},
        {"from": "all.things", "path": "nodes.glb", "instances": "nodes", "ground": False},
        {"from": "all.things", "path": "blender.csv", "engine": "blender"}],
}

LOOK = """
import bpy, json, sys
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=sys.argv[sys.argv.index('--') + 1])
objects = [o for o in bpy.context.scene.objects if o.type == 'MESH']
bpy.context.view_layer.update()
print('RESULT ' + json.dumps({
    'places': sorted([list(o.matrix_world.translation) for o in objects]),
    'tops': sorted([list(o.matrix_world.to_3x3().col[2].normalized()) for o in objects]),
    'meshes': len({o.data.name for o in objects})}))
"""

VALIDATE = """
const validator = require('gltf-validator'), fs = require('fs');
Promise.all(process.argv.slice(2).map(
  path => validator.validateBytes(new Uint8Array(fs.readFileSync(path)), {maxIssues: 20}))).then(
  reports => console.log(JSON.stringify(reports.map(report => report.issues))));
"""


def made(bench):
    bench.path("things.json").write_text(json.dumps(RECIPE))
    bench.seamount("run", "things.json", "--out", ".")


def check_validator(bench):
    env = bench.node_module("gltf-validator")
    made(bench)
    bench.path("validate.js").write_text(VALIDATE)
    for issues in json.loads(bench.run("node", "validate.js", "instances.glb", "nodes.glb", env=env)):
        assert issues["numErrors"] == 0, issues


@needs("blender")
def check_blender_shows_them_where_the_table_says(bench):
    made(bench)
    seen = bench.blender(LOOK, "nodes.glb")
    with bench.path("blender.csv").open() as file:
        rows = list(csv.DictReader(file))
    wanted = sorted([float(row[k]) for k in "xyz"] for row in rows)
    assert len(rows) == len(seen["places"]) > 40
    for place, want in zip(seen["places"], wanted):
        assert all(abs(a - b) < 1e-3 for a, b in zip(place, want)), (place, want)
    assert seen["meshes"] == len({row["mesh"] for row in rows})

    def up(row):
        x, y, z, w = (float(row[k]) for k in ("qx", "qy", "qz", "qw"))
        return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]

    for top, want in zip(seen["tops"], sorted(up(row) for row in rows)):
        assert all(abs(a - b) < 2e-3 for a, b in zip(top, want)), (top, want)


@needs("assimp")
def check_assimp_reads_each_shape(bench):
    made(bench)
    for path in sorted(bench.path("blender_shapes").glob("*.glb"))[:6]:
        said = bench.run("assimp", "info", path)
        assert "Meshes:" in said, said
