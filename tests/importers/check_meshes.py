"""Meshes: gltf-validator, assimp and Blender."""

import json
import re

from bench import needs

VALIDATE = """
const validator = require('gltf-validator'), fs = require('fs');
const bytes = async path => new Uint8Array(fs.readFileSync(path));
Promise.all(process.argv.slice(2).map(async path =>
  validator.validateBytes(await bytes(path), {maxIssues: 20, externalResourceFunction: bytes}))).then(
  reports => console.log(JSON.stringify(reports.map(report => report.issues))));
"""

# All files of the command line in one mesh, vertices in one place joined: what is left open, and what is wrong.
LOOK = """
import bmesh, bpy, json, sys
bpy.ops.wm.read_factory_settings(use_empty=True)
for path in sys.argv[sys.argv.index('--') + 1:]:
    if path.endswith('.stl'):
        bpy.ops.import_mesh.stl(filepath=path)
    elif path.endswith('.ply'):
        bpy.ops.import_mesh.ply(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)
places, faces = {}, []
for o in bpy.context.scene.objects:
    if o.type == 'MESH':
        mesh = o.to_mesh()
        mesh.transform(o.matrix_world)
        for face in mesh.polygons:
            corners = [tuple(mesh.vertices[v].co) for v in face.vertices]
            faces.append([places.setdefault(corner, len(places)) for corner in corners])
joined = bpy.data.meshes.new('joined')
joined.from_pydata(list(places), [], faces)
bm = bmesh.new()
bm.from_mesh(joined)
xs, ys, zs = ([v.co[k] for v in bm.verts] for k in range(3))
low, high = [min(xs), min(ys), min(zs)], [max(xs), max(ys), max(zs)]
def on_rim(v):
    return v.co.x in (low[0], high[0]) or v.co.y in (low[1], high[1])
print('RESULT ' + json.dumps({
    'low': low, 'high': high, 'faces': len(bm.faces),
    'facing_down': sum(f.normal.z < 0 for f in bm.faces),
    'without_area': sum(f.calc_area() == 0 for f in bm.faces),
    'crowded_edges': sum(len(e.link_faces) > 2 for e in bm.edges),
    'turned_edges': sum(len(e.link_faces) == 2 and not e.is_contiguous for e in bm.edges),
    'open_edges': sum(len(e.link_faces) < 2 for e in bm.edges),
    'open_inside': sum(len(e.link_faces) < 2 and not (on_rim(e.verts[0]) and on_rim(e.verts[1])) for e in bm.edges),
    'volume': bm.calc_volume(signed=True)}))
"""

SMALL = ("--set", "max_triangles=20000", "--set", "texture_px=0", "--set", "water=false")

TILES = ("--set", "tile_size=100", "--set", "lods=2", "--set", "max_error_m=3")


def heights_of(bench, name):
    """The extent and the heights that `seamount info` tells."""
    info = dict(re.split(r"\s{2,}", line, maxsplit=1) for line in bench.seamount("info", name).splitlines() if "  " in line)
    numbers = re.findall(r"-?[\d.]+(?:e-?\d+)?", info["extent"] + " " + info["heights"].replace("to", " "))
    return [float(n) for n in numbers]


def assert_same_place(bench, seen, name):
    width, depth, low, high = heights_of(bench, name)
    for told, found in zip((width, depth, low, high), (seen["high"][0] - seen["low"][0], seen["high"][1] - seen["low"][1],
                                                       seen["low"][2], seen["high"][2])):
        assert abs(told - found) <= 1e-5 * max(abs(told), width), (told, found)


def check_glb_is_valid(bench):
    env = bench.node_module("gltf-validator")
    bench.path("validate.js").write_text(VALIDATE)
    island = bench.island()
    bench.seamount("convert", island, "sea.glb", "--set", "max_triangles=20000", "--set", "texture_px=256")
    bench.seamount("convert", island, "sheet.glb", "--set", "max_triangles=20000", "--set", "texture_px=0")
    bench.seamount("convert", island, "solid.glb", "--set", "max_triangles=20000", "--set", "base_m=100")
    bench.seamount("convert", island, "tile.glb", "--set", "tiles=2", "--set", "lods=2", "--set", "texture_px=100")
    bench.seamount("convert", island, "world.glb", "--as", "mesh_tiles", *TILES, "--set", "texture_px=100")
    files = sorted(path.name for pattern in ("*.glb", "*.gltf") for path in bench.folder.glob(pattern))
    assert len(files) == 3 + 2 * 2 * 2 + 3 * 3 * 2 + 1, files
    for file, issues in zip(files, json.loads(bench.run("node", "validate.js", *files, env=env))):
        assert issues["numErrors"] == 0 and issues["numWarnings"] == 0, (file, issues)


@needs("assimp")
def check_assimp_reads_all_formats(bench):
    island = bench.island()
    for kind in ("glb", "obj", "ply", "stl"):
        bench.seamount("convert", island, f"island.{kind}", *SMALL)
        said = bench.run("assimp", "info", f"island.{kind}")
        faces = int(re.search(r"Faces:\s*(\d+)", said)[1])
        assert 19000 <= faces <= 20000, said


@needs("blender")
def check_blender_sees_a_surface_that_faces_up(bench):
    island = bench.island()
    bench.seamount("convert", island, "island.glb", *SMALL)
    seen = bench.blender(LOOK, "island.glb")
    assert_same_place(bench, seen, "island.glb")
    assert seen["facing_down"] == seen["without_area"] == seen["crowded_edges"] == seen["turned_edges"] == 0, seen
    assert seen["open_inside"] == 0, seen


@needs("blender")
def check_blender_sees_closed_solids(bench):
    island = bench.island()
    for kind in ("glb", "ply", "stl"):
        bench.seamount("convert", island, f"solid.{kind}", *SMALL, "--set", "base_m=100")
        seen = bench.blender(LOOK, f"solid.{kind}")
        assert_same_place(bench, seen, f"solid.{kind}")
        assert seen["open_edges"] == seen["without_area"] == seen["crowded_edges"] == seen["turned_edges"] == 0, (kind, seen)
        assert seen["volume"] > 0, (kind, seen)


@needs("blender")
def check_blender_sees_no_cracks_between_tiles(bench):
    """Tiles of different levels, loaded as they are, share every vertex and edge of their borders."""
    bench.seamount("convert", bench.island(), "tile.glb", *SMALL, "--set", "tiles=3", "--set", "lods=3")
    mixed = [f"tile_x{x}_y{y}_lod{(x + y) % 3}.glb" for x in range(3) for y in range(3)]
    seen = bench.blender(LOOK, *mixed)
    assert seen["facing_down"] == seen["crowded_edges"] == seen["turned_edges"] == seen["open_inside"] == 0, seen


@needs("blender")
def check_blender_sees_no_cracks_in_a_scene_of_tiles(bench):
    """The scene places tiles that were made one by one; levels of any other tiles fit them."""
    bench.seamount("convert", bench.island(), "world.glb", "--as", "mesh_tiles", *TILES, "--set", "texture_px=0")
    seen = bench.blender(LOOK, "world.gltf")
    assert seen["facing_down"] == seen["crowded_edges"] == seen["turned_edges"] == seen["open_inside"] == 0, seen
