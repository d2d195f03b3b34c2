# SPDX-License-Identifier: MIT
"""The scene, the prefab and the material of the sample Leaf storm, as the text that Unity saves; and a check that every reference in
such text leads somewhere."""
import re

import metas

FOLDER = "Samples~/LeafStorm/"
BUILTIN_MESHES, BUILTIN_ASSETS = "0000000000000000e000000000000000", "0000000000000000f000000000000000"
CUBE, SPHERE, DEFAULT_MATERIAL, SKYBOX, STANDARD_SHADER = 10202, 10207, 10303, 10304, 46
HEAD = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"
SOURCE = "  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {fileID: 0}\n  m_PrefabInstance: {fileID: 0}\n  m_PrefabAsset: {fileID: 0}\n"


def xxhash64(data):
    p = (11400714785074694791, 14029467366897019727, 1609587929392839161, 9650029242287828579, 2870177450012600261)
    mask = (1 << 64) - 1

    def turn(x, by):
        return (x << by | x >> (64 - by)) & mask

    def mix(a, lane):
        return turn((a + lane * p[1]) & mask, 31) * p[0] & mask
    at, h = 0, p[4]
    if len(data) >= 32:
        lanes = [(p[0] + p[1]) & mask, p[1], 0, -p[0] & mask]
        while at + 32 <= len(data):
            lanes = [mix(lane, int.from_bytes(data[at + 8 * i:at + 8 * i + 8], "little")) for i, lane in enumerate(lanes)]
            at += 32
        h = sum(turn(lane, by) for lane, by in zip(lanes, (1, 7, 12, 18))) & mask
        for lane in lanes:
            h = ((h ^ mix(0, lane)) * p[0] + p[3]) & mask
    h = (h + len(data)) & mask
    while at + 8 <= len(data):
        h = (turn(h ^ mix(0, int.from_bytes(data[at:at + 8], "little")), 27) * p[0] + p[3]) & mask
        at += 8
    if at + 4 <= len(data):
        h = (turn(h ^ int.from_bytes(data[at:at + 4], "little") * p[0] & mask, 23) * p[1] + p[2]) & mask
        at += 4
    for byte in data[at:]:
        h = turn(h ^ byte * p[4] & mask, 11) * p[0] & mask
    h = (h ^ h >> 33) * p[1] & mask
    h = (h ^ h >> 29) * p[2] & mask
    return h ^ h >> 32


def imported_id(kind, name):
    """The fileID of the first object of this type and name that an importer made, since Unity 2019.3."""
    value = xxhash64(f"Type:{kind}->{name}0".encode())
    return value - (1 << 64) if value >> 63 else value


def vector(x, y, z):
    return f"{{x: {x:g}, y: {y:g}, z: {z:g}}}"


class File:
    """Objects of a scene or prefab, with fileIDs that count."""

    def __init__(self):
        self.documents, self.last = [], 0

    def add(self, kind, name, body, stripped=False):
        self.last += 1
        self.documents.append((kind, self.last, name, body, stripped))
        return self.last

    def body(self, at, extra):
        kind, number, name, body, stripped = self.documents[at - 1]
        self.documents[at - 1] = (kind, number, name, body + extra, stripped)

    def game_object(self, name, position, *components, scale=(1, 1, 1), turn=(0, 0, 0, 1), parent=0, tag="Untagged"):
        """Components: (class id, class, body). Returns the fileID of its transform."""
        first = self.last + 1
        ids = range(first + 1, first + 2 + len(components))
        self.add(1, "GameObject", SOURCE + "  serializedVersion: 6\n  m_Component:\n" +
                 "".join(f"  - component: {{fileID: {i}}}\n" for i in ids) +
                 f"  m_Layer: 0\n  m_Name: {name}\n  m_TagString: {tag}\n  m_Icon: {{fileID: 0}}\n  m_NavMeshLayer: 0\n  m_StaticEditorFlags: 0\n"
                 "  m_IsActive: 1\n")
        self.add(4, "Transform", SOURCE + f"  m_GameObject: {{fileID: {first}}}\n  serializedVersion: 2\n"
                 f"  m_LocalRotation: {{x: {turn[0]:g}, y: {turn[1]:g}, z: {turn[2]:g}, w: {turn[3]:g}}}\n  m_LocalPosition: {vector(*position)}\n"
                 f"  m_LocalScale: {vector(*scale)}\n  m_ConstrainProportionsScale: 0\n  m_Father: {{fileID: {parent}}}\n"
                 "  m_LocalEulerAnglesHint: {x: 0, y: 0, z: 0}\n")
        for kind, class_name, body in components:
            self.add(kind, class_name, SOURCE + f"  m_GameObject: {{fileID: {first}}}\n" + body)
        return first + 1

    def text(self):
        children = {}
        for _, number, name, body, stripped in self.documents:
            father = re.search(r"m_(?:Father|TransformParent): \{fileID: (\d+)\}", body)
            if name == "Transform" and stripped:
                father = re.search(r"m_PrefabInstance: \{fileID: (\d+)\}", body)
                father = re.search(r"m_TransformParent: \{fileID: (\d+)\}", self.documents[int(father.group(1)) - 1][3])
            if name == "Transform" and father:
                children.setdefault(int(father.group(1)), []).append(number)
        out = HEAD
        for kind, number, name, body, stripped in self.documents:
            if name == "Transform" and not stripped:
                mine = "".join(f"  - {{fileID: {i}}}\n" for i in children.get(number, []))
                body = body.replace("  m_Father:", f"  m_Children:{' []' if not mine else ''}\n{mine}  m_Father:")
            out += f"--- !u!{kind} &{number}{' stripped' if stripped else ''}\n{name}:\n{body}"
        return out


def script(path, fields=""):
    return (114, "MonoBehaviour", "  m_Enabled: 1\n  m_EditorHideFlags: 0\n"
            f"  m_Script: {{fileID: 11500000, guid: {metas.guid(path)}, type: 3}}\n  m_Name: \n  m_EditorClassIdentifier: \n{fields}")


def solid(mesh, collider):
    material = f"  m_Materials:\n  - {{fileID: {DEFAULT_MATERIAL}, guid: {BUILTIN_ASSETS}, type: 0}}\n"
    return [(33, "MeshFilter", f"  m_Mesh: {{fileID: {mesh}, guid: {BUILTIN_MESHES}, type: 0}}\n"),
            (23, "MeshRenderer", "  m_Enabled: 1\n  m_CastShadows: 1\n  m_ReceiveShadows: 1\n  m_DynamicOccludee: 1\n  m_MotionVectors: 1\n"
             f"  m_LightProbeUsage: 1\n  m_ReflectionProbeUsage: 1\n  m_RenderingLayerMask: 1\n{material}"), collider,
            script("Runtime/LangevinCollider.cs")]


BOX = (65, "BoxCollider", "  m_Material: {fileID: 0}\n  m_IsTrigger: 0\n  m_Enabled: 1\n  serializedVersion: 2\n"
       "  m_Size: {x: 1, y: 1, z: 1}\n  m_Center: {x: 0, y: 0, z: 0}\n")
BALL = (135, "SphereCollider", "  m_Material: {fileID: 0}\n  m_IsTrigger: 0\n  m_Enabled: 1\n  serializedVersion: 2\n"
        "  m_Radius: 0.5\n  m_Center: {x: 0, y: 0, z: 0}\n")


def prefab():
    """20,000 leaves that fall from a box and come again."""
    mesh = f"{{fileID: {imported_id('Mesh', 'leaf')}, guid: {metas.guid(FOLDER + 'leaf.obj')}, type: 3}}"
    asset = f"{{fileID: {imported_id('MonoBehaviour', 'asset')}, guid: {metas.guid(FOLDER + 'leaf.lrb')}, type: 3}}"
    file = File()
    file.game_object("Leaves", (0, 12, 0), script("Runtime/LangevinBatch.cs", f"""  asset: {asset}
  capacity: 20000
  startCount: 10000
  emitter:
    enabled: 1
    size: {{x: 25, y: 4, z: 25}}
    rate: 1000
    scale: {{x: 0.8, y: 1.4}}
  rules:
    enabled: 1
    action: 1
    volumes:
    - shape: 1
      side: 1
      center: {{x: 0, y: 10, z: 0}}
      size: {{x: 30, y: 15, z: 30}}
  drawing:
    mode: 1
    mesh: {mesh}
    materials:
    - {{fileID: 2100000, guid: {metas.guid(FOLDER + 'Leaf.mat')}, type: 2}}
"""))
    return file.text(), 2 # the fileID of its transform


def scene(prefab_transform):
    file = File()
    file.add(104, "RenderSettings", "  m_ObjectHideFlags: 0\n  serializedVersion: 9\n  m_Fog: 0\n  m_AmbientMode: 0\n  m_AmbientIntensity: 1\n"
             f"  m_SkyboxMaterial: {{fileID: {SKYBOX}, guid: {BUILTIN_ASSETS}, type: 0}}\n  m_DefaultReflectionMode: 0\n"
             "  m_DefaultReflectionResolution: 128\n  m_ReflectionBounces: 1\n  m_ReflectionIntensity: 1\n  m_Sun: {fileID: 0}\n")
    file.game_object("Main Camera", (0, 4, -22), (20, "Camera", "  m_Enabled: 1\n  serializedVersion: 2\n  m_ClearFlags: 1\n"
                     "  m_BackGroundColor: {r: 0.19, g: 0.3, b: 0.47, a: 0}\n  near clip plane: 0.1\n  far clip plane: 200\n  field of view: 60\n"
                     "  orthographic: 0\n  m_Depth: -1\n  m_CullingMask:\n    serializedVersion: 2\n    m_Bits: 4294967295\n"),
                     (81, "AudioListener", "  m_Enabled: 1\n"), tag="MainCamera")
    file.game_object("Directional Light", (0, 3, 0), (108, "Light", "  m_Enabled: 1\n  serializedVersion: 10\n  m_Type: 1\n"
                     "  m_Color: {r: 1, g: 0.957, b: 0.839, a: 1}\n  m_Intensity: 1\n  m_Shadows:\n    m_Type: 2\n    m_Resolution: -1\n"
                     "    m_CustomResolution: -1\n    m_Strength: 1\n    m_Bias: 0.05\n    m_NormalBias: 0.4\n    m_NearPlane: 0.2\n"),
                     turn=(0.408218, -0.234570, 0.109382, 0.875426))
    root = file.game_object("Leaf Storm", (0, 0, 0), script("Runtime/LangevinWorld.cs", "  stepThread: 1\n"), script(FOLDER + "LeafStorm.cs"))
    file.game_object("Lawn", (0, -0.5, 0), *solid(CUBE, BOX), scale=(60, 1, 60), parent=root)
    for i in range(5):
        file.game_object(f"Crate {i + 1}", (4 * i - 8, 0.5, 3), *solid(CUBE, BOX), parent=root)
    ball = file.game_object("Ball", (0, 0.75, -8), *solid(SPHERE, BALL), scale=(1.5, 1.5, 1.5), parent=root)
    file.body(root + 2, f"  ball: {{fileID: {ball}}}\n")
    file.game_object("Wind", (0, 2, 0), (182, "WindZone", "  m_Enabled: 1\n  m_Mode: 0\n  m_Radius: 20\n  m_WindMain: 4\n  m_WindTurbulence: 0.4\n"
                     "  m_WindPulseMagnitude: 0.6\n  m_WindPulseFrequency: 0.1\n"), script("Runtime/LangevinWind.cs"),
                     turn=(0, 0.5, 0, 0.8660254), parent=root)
    guid = metas.guid(FOLDER + "Leaves.prefab")
    instance = file.add(1001, "PrefabInstance", f"  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Modification:\n    m_TransformParent: {{fileID: {root}}}\n"
                        f"    m_Modifications: []\n    m_RemovedComponents: []\n  m_SourcePrefab: {{fileID: 100100000, guid: {guid}, type: 3}}\n")
    file.add(4, "Transform", f"  m_CorrespondingSourceObject: {{fileID: {prefab_transform}, guid: {guid}, type: 3}}\n"
             f"  m_PrefabInstance: {{fileID: {instance}}}\n  m_PrefabAsset: {{fileID: 0}}\n", stripped=True)
    return file.text()


def material():
    return (HEAD + "--- !u!21 &2100000\nMaterial:\n  serializedVersion: 8\n  m_ObjectHideFlags: 0\n  m_Name: Leaf\n"
            f"  m_Shader: {{fileID: {STANDARD_SHADER}, guid: {BUILTIN_ASSETS}, type: 0}}\n  m_EnableInstancingVariants: 1\n  m_DoubleSidedGI: 0\n"
            "  m_CustomRenderQueue: -1\n  m_SavedProperties:\n    serializedVersion: 3\n    m_TexEnvs: []\n    m_Ints: []\n    m_Floats:\n"
            "    - _Glossiness: 0.2\n    - _Metallic: 0\n    m_Colors:\n    - _Color: {r: 0.75, g: 0.4, b: 0.1, a: 1}\n")


def write(folder):
    text, transform = prefab()
    for name, content, importer in [("Leaves.prefab", text, "PrefabImporter"), ("LeafStorm.unity", scene(transform), "DefaultImporter"),
                                    ("Leaf.mat", material(), "NativeFormatImporter")]:
        (folder / name).write_text(content)
        extra = "  mainObjectFileID: 2100000\n" if name.endswith(".mat") else ""
        (folder / f"{name}.meta").write_text(f"fileFormatVersion: 2\nguid: {metas.guid(FOLDER + name)}\n{metas.importer(importer, extra)}")
    # Without importer settings Unity takes its own.
    (folder / "leaf.obj.meta").write_text(f"fileFormatVersion: 2\nguid: {metas.guid(FOLDER + 'leaf.obj')}\n")


def check(package):
    """References in scenes and prefabs of samples that lead nowhere, and components that their objects do not list."""
    faults, files = [], {}
    for at in package.rglob("*.meta"):
        guid = re.search(r"^guid: (\w+)$", at.read_text(), re.M)
        if guid:
            files[guid.group(1)] = at.with_suffix("")
    made = {"leaf.obj": imported_id("Mesh", "leaf"), "leaf.lrb": imported_id("MonoBehaviour", "asset")}
    for file in sorted([*package.rglob("*.unity"), *package.rglob("*.prefab"), *package.rglob("*.mat")]):
        parts = re.split(r"^--- !u!(\d+) &(\d+)(?: stripped)?\n", file.read_text(), flags=re.M)[1:]
        inside = {number: (kind, body) for kind, number, body in zip(parts[::3], parts[1::3], parts[2::3])}
        for number, (kind, body) in inside.items():
            where = f"{file.name}, object {number}"
            for target, guid in re.findall(r"\{fileID: (-?\d+)(?:, guid: (\w+), type: \d)?\}", body):
                if guid in (BUILTIN_MESHES, BUILTIN_ASSETS) or (target == "0" and not guid):
                    continue
                if not guid:
                    if target not in inside:
                        faults.append(f"{where}: no object {target}")
                elif guid not in files:
                    faults.append(f"{where}: no file has the GUID {guid}")
                elif not files[guid].exists():
                    faults.append(f"{where}: {files[guid].name} is not there")
                elif files[guid].suffix == ".cs":
                    if target != "11500000" or not re.search(rf"\bclass {files[guid].stem}\b", files[guid].read_text()):
                        faults.append(f"{where}: {files[guid].name} has no class of its name")
                elif files[guid].name in made:
                    if int(target) != made[files[guid].name]:
                        faults.append(f"{where}: {files[guid].name} has no object {target}")
                elif target != "100100000" and f"&{target}\n" not in files[guid].read_text():
                    faults.append(f"{where}: {files[guid].name} has no object {target}")
            owner = re.search(r"^  m_GameObject: \{fileID: (\d+)\}", body, re.M)
            if owner and f"component: {{fileID: {number}}}" not in inside.get(owner.group(1), ("", ""))[1]:
                faults.append(f"{where}: not a component of {owner.group(1)}")
    return faults
