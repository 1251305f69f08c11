"""fmb mesh of scenes: glTF and 3MF say what the same triangles say as OBJ, wherever they are put; and files that are cut off, or have
other bytes, are told, or read, and crash nothing. usage: scenes.py FMB"""

import base64
import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import zipfile

fmb = sys.argv[1]
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
CORNERS = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]
# A tetrahedron as it is, a quarter further on, and turned by 90 degrees, twice as large, below the second one.
PLACES = [("left part", lambda x, y, z: (x, y, z)), ("right", lambda x, y, z: (x + .25, y + .25, z + .25)),
          ("tet", lambda x, y, z: (.25 - 2 * y, .25 + 2 * x, .25 + 2 * z))]
HALF = 0.7071067811865476
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def ask(path, *words):
    got = subprocess.run([fmb, "mesh", path, *words], capture_output=True, text=True, errors="replace", timeout=600)
    return got.returncode, got.stdout, got.stderr


def obj():
    text, base = "", 1
    for name, place in PLACES:
        text += f"o {name}\n" + "".join("v %r %r %r\n" % place(*p) for p in POINTS)
        text += "".join(f"f {' '.join(str(base + c) for c in CORNERS[i:i + 3])}\n" for i in range(0, 12, 3))
        base += 4
    return text


def gltf(uri):
    """Numbers between others, as byteStride allows; indices of two bytes."""
    data = b"".join(struct.pack("<3ff", *p, 9) for p in POINTS) + struct.pack("<12H", *CORNERS)
    scene = {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}], "buffers": [{"byteLength": len(data)}],
        "nodes": [{"name": "left part", "mesh": 0}, {"name": "right", "mesh": 0, "translation": [.25, .25, .25], "children": [2]},
                  {"mesh": 0, "scale": [2, 2, 2], "rotation": [0, 0, HALF, HALF]}],
        "meshes": [{"name": "tet", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}, {"mode": 1, "attributes": {}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 64, "byteStride": 16}, {"buffer": 0, "byteOffset": 64, "byteLength": 24}]}
    if uri is not None:
        scene["buffers"][0]["uri"] = uri
    return scene, data


def glb(scene, data):
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(data), b"BIN\0") + data)


def model():
    mesh = ("".join('<vertex x="%g" y="%g" z="%g"/>' % p for p in POINTS),
            "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(CORNERS[i:i + 3]) for i in range(0, 12, 3)))
    objects = "".join('<object id="%d" name="%s"><mesh><vertices>%s</vertices><triangles>%s</triangles></mesh></object>' % (i, name, *mesh)
                      for i, (name, _) in enumerate(PLACES, 1))
    pair = ('<object id="7"><components><component objectid="2"/>'
            '<component objectid="3" transform="0 2 0 -2 0 0 0 0 2 0 0 0"/></components></object>')
    return (f'<?xml version="1.0"?>\n<model><resources>{objects}{pair}</resources>\n<build><item objectid="1"/>'
            '<item objectid="7" transform="1 0 0 0 1 0 0 0 1 .25 .25 .25"/></build></model>')


def write_3mf(path, text, name="3D/3dmodel.model"):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as z:
        z.writestr("[Content_Types].xml", "<Types/>")
        z.writestr(name, text)


def compare_with_obj(home):
    """Turned by a quaternion of rounded numbers, the third one is a little off: so equal in what crosses, not in what touches."""
    (home / "a.obj").write_text(obj())
    scene, data = gltf("data:application/octet-stream;base64," + base64.b64encode(gltf(None)[1]).decode())
    (home / "a.gltf").write_text(json.dumps(scene))
    (home / "b.gltf").write_text(json.dumps(gltf("in%20bytes.bin")[0]))
    (home / "in bytes.bin").write_bytes(data)
    (home / "c.GLB").write_bytes(glb(*gltf(None)))
    write_3mf(home / "d.3mf", model())
    write_3mf(home / "e.3mf", model(), "3D/other.model")
    want = ask(home / "a.obj", "--csv")
    crossing = [line for line in want[1].splitlines() if line.startswith("cross")]
    expect(want[0] == 0 and len(crossing) > 3 and '"left part","right"' in want[1], f"OBJ: {want}")
    for name in ("a.gltf", "b.gltf", "c.GLB", "d.3mf", "e.3mf"):
        got = ask(home / name, "--csv")
        if "built without" in got[2]:
            print("no 3MF in this build")
            continue
        expect(got[0] == 0 and [line for line in got[1].splitlines() if line.startswith("cross")] == crossing, f"{name}: {got}")
    expect(ask(home / "d.3mf", "--csv") == want or "built without" in ask(home / "d.3mf")[2], "3MF without roundings is the OBJ")


def mistakes(home):
    scene, data = gltf(None)

    def changed(change):
        other = json.loads(json.dumps(scene))
        change(other)
        (home / "x.glb").write_bytes(glb(other, data))
        return ask(home / "x.glb")

    for what, change in {
            "inside its buffer": lambda s: s["accessors"][0].update(count=5), "entries of accessor": lambda s: s["bufferViews"][0].update(byteOffset=80),
            "bytes in buffer": lambda s: s["buffers"][0].update(byteLength=99), "children of themselves": None,
            "one of 4 positions": lambda s: s["accessors"][1].update(componentType=5125, count=6), "version 2": lambda s: s["asset"].update(version="1.0"),
            "draco": lambda s: s.update(extensionsRequired=["KHR_draco_mesh_compression"]),
            "not negative": lambda s: s["nodes"][0].update(mesh=-1), "\"meshes\"": lambda s: s["nodes"][0].update(mesh=5),
            "16 numbers": lambda s: s["nodes"][0].update(matrix=[1, 2]), "beside this one": lambda s: s["buffers"][0].update(uri="/etc/passwd"),
            "base64": lambda s: s["buffers"][0].update(uri="data:x;base64,!!"), "finite": lambda s: s["nodes"][0].update(scale=[1e308, 1, 1], translation=[1e308, 0, 0]),
            "one node at most": lambda s: s["nodes"].append({"children": [2]})}.items():
        got = changed(change or (lambda s: (s.pop("scenes"), s["nodes"][2].update(children=[1]), s["nodes"].append({"children": [0]}),
                                            s.update(scenes=[{"nodes": [1]}]))))
        expect(got[0] == 65 and what in got[2] and got[1] == "" and str(home / "x.glb") in got[2], f"{what}: {got}")
    (home / "x.gltf").write_text('{"asset":\n {]}')
    expect(f"{home}/x.gltf:2:3: " in ask(home / "x.gltf")[2], "place in JSON")
    for what, text in {":2:1: ": "<model>\n<object id='x'/></model>", "4 vertices": model().replace('v1="0"', 'v1="4"'), "id 9": model().replace('objectid="1"', 'objectid="9"'),
                       "of themselves": model().replace('objectid="3"', 'objectid="7"'), "document type": "<!DOCTYPE x [<!ENTITY y 'z'>]><model/>",
                       "12 numbers": model().replace('transform="0 2', 'transform="x'), "of another": model().replace('<item ', '<item p:path="x" ')}.items():
        write_3mf(home / "x.3mf", text)
        got = ask(home / "x.3mf")
        expect("built without" in got[2] or (got[0] == 65 and what in got[2]), f"{what}: {got}")
    # Objects of objects, each twice: 2^40 of nothing.
    many = "".join(f'<object id="{i}"><components><component objectid="{i - 1}"/><component objectid="{i - 1}"/></components></object>' for i in range(2, 42))
    write_3mf(home / "x.3mf", f'<model><object id="1"/>{many}<build><item objectid="41"/></build></model>')
    got = ask(home / "x.3mf")
    expect("built without" in got[2] or (got[0] == 65 and "at their places" in got[2]), f"many: {got}")


def other_bytes(home):
    draw = random.Random(7)
    for name in ("a.gltf", "c.GLB", "d.3mf"):
        whole = (home / name).read_bytes()
        for _ in range(40):
            text = bytearray(whole[:draw.randrange(len(whole))] if draw.random() < .3 else whole)
            for _ in range(draw.randrange(4)):
                if text:
                    text[draw.randrange(len(text))] = draw.randrange(256)
            path = home / ("other" + pathlib.Path(name).suffix)
            path.write_bytes(text)
            got = ask(path)
            expect(got[0] in (0, 1, 65, 66), f"{name} with other bytes: {got[0]} {got[2]}")


with tempfile.TemporaryDirectory() as name:
    compare_with_obj(pathlib.Path(name))
    mistakes(pathlib.Path(name))
    other_bytes(pathlib.Path(name))
print("\n".join(faults) or "scenes: no faults")
sys.exit(bool(faults))
