"""Meshes and a writer of binary glTF 2.0 on the standard library alone. Used by models.py.

Lengths in metres, right-handed, y up. Triangles are counter-clockwise seen from outside.
"""
import json
import math
import struct
import zlib


def add(a, b): return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def sub(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def mul(a, s): return (a[0] * s, a[1] * s, a[2] * s)
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def length(a): return math.sqrt(dot(a, a))
def lerp(a, b, t): return a + (b - a) * t


def unit(a, otherwise=(0.0, 1.0, 0.0)):
    size = length(a)
    return mul(a, 1.0 / size) if size > 1e-12 else otherwise


class Mesh:
    """Triangles by material name. A corner is (position, normal, uv)."""

    def __init__(self):
        self.parts = {}

    def triangle(self, material, corners):
        a, b, c = (corner[0] for corner in corners)
        if length(cross(sub(b, a), sub(c, a))) < 1e-9:
            return
        vertices, indices, known = self.parts.setdefault(material, ([], [], {}))
        for corner in corners:
            key = tuple(round(value, 5) for part in corner for value in part)
            if key not in known:
                known[key] = len(vertices)
                vertices.append(corner)
            indices.append(known[key])

    def extend(self, other, move=(0.0, 0.0, 0.0)):
        for material, (vertices, indices, _) in other.parts.items():
            for k in range(0, len(indices), 3):
                self.triangle(material, [(add(vertices[i][0], move), vertices[i][1], vertices[i][2])
                                         for i in indices[k:k + 3]])
        return self

    def grid(self, rows, material, closed=False, uv=None, inward=False):
        """A smooth skin over rows of points. `closed`: the last point of a row joins the first. `material` is a
        name or f(i, j) -> name or None (a hole). The outside is away from each row's middle, or
        towards it with `inward`; the ends of a closed skin stay open (see `fan`). uv: f(point, i, j)."""
        count = len(rows[0])
        span = count if closed else count - 1
        name = material if callable(material) else (lambda i, j: material)
        uv = uv or (lambda p, i, j: (0.0, 0.0))
        normals = [[(0.0, 0.0, 0.0)] * count for _ in rows]
        outside = 0.0
        for i in range(len(rows) - 1):
            middle = mul(self._sum(rows[i] + rows[i + 1]), 1.0 / (2 * count))
            for j in range(span):
                k = (j + 1) % count
                quad = (rows[i][j], rows[i][k], rows[i + 1][k], rows[i + 1][j])
                face = cross(sub(quad[2], quad[0]), sub(quad[3], quad[1]))
                outside += dot(face, sub(mul(self._sum(quad), 0.25), middle))
                for r, c in ((i, j), (i, k), (i + 1, k), (i + 1, j)):
                    normals[r][c] = add(normals[r][c], face)
        turn = (outside < 0.0) != inward
        normals = [[unit(mul(n, -1.0) if turn else n) for n in row] for row in normals]
        for i in range(len(rows) - 1):
            for j in range(span):
                which = name(i, j)
                if which is None:
                    continue
                k = (j + 1) % count
                q = [(rows[r][c], normals[r][c], uv(rows[r][c], i, j)) for r, c in
                     ((i, j), (i, k), (i + 1, k), (i + 1, j))]
                if turn:
                    q.reverse()
                self.triangle(which, (q[0], q[1], q[2]))
                self.triangle(which, (q[0], q[2], q[3]))
        return self

    def fan(self, ring, material, normal, uv=None):
        """A flat lid over a ring of points, seen from `normal`."""
        uv = uv or (lambda p: (0.0, 0.0))
        middle = mul(self._sum(ring), 1.0 / len(ring))
        for a, b in zip(ring, ring[1:] + ring[:1]):
            corners = [middle, a, b]
            if dot(cross(sub(a, middle), sub(b, middle)), normal) < 0.0:
                corners = [middle, b, a]
            self.triangle(material, [(p, normal, uv(p)) for p in corners])
        return self

    def quad(self, corners, material):
        """Flat, counter-clockwise."""
        normal = unit(cross(sub(corners[1], corners[0]), sub(corners[3], corners[0])))
        c = [(p, normal, (0.0, 0.0)) for p in corners]
        self.triangle(material, (c[0], c[1], c[2]))
        self.triangle(material, (c[0], c[2], c[3]))
        return self

    def box(self, middle, size, material, bevel=0.0):
        """A box whose edges are cut by `bevel`: flat faces, chamfers between them."""
        half = mul(size, 0.5)
        inner = tuple(h - bevel for h in half)

        def corner(axis, signs):  # the box corner on the face of `axis`
            return add(middle, tuple(signs[i] * (half[i] if i == axis else inner[i]) for i in range(3)))
        signs8 = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (-1, 1):
                ring = []
                for su, sv in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                    signs = [0, 0, 0]
                    signs[axis], signs[u], signs[v] = side, su, sv
                    ring.append(corner(axis, signs))
                self.quad(ring if side > 0 else ring[::-1], material)
        if bevel > 0.0:
            for axis in range(3):  # chamfers along `axis`
                u, v = (axis + 1) % 3, (axis + 2) % 3
                for su in (-1, 1):
                    for sv in (-1, 1):
                        ends = []
                        for s in (-1, 1):
                            signs = [0, 0, 0]
                            signs[axis], signs[u], signs[v] = s, su, sv
                            ends.append((corner(u, signs), corner(v, signs)))
                        ring = [ends[0][0], ends[0][1], ends[1][1], ends[1][0]]
                        self.quad(self._facing(ring, middle), material)
            for signs in signs8:
                ring = [corner(axis, signs) for axis in range(3)]
                normal = unit(signs)
                if dot(cross(sub(ring[1], ring[0]), sub(ring[2], ring[0])), normal) < 0:
                    ring.reverse()
                self.triangle(material, [(p, normal, (0.0, 0.0)) for p in ring])
        return self

    def tube(self, path, radii, material, sides=12, flat=1.0, up=(0.0, 1.0, 0.0), lids=True):
        """A round bar along `path`. Its section is `flat` times as thick along `up` as across."""
        rows = []
        for i, p in enumerate(path):
            ahead = unit(sub(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]))
            side = unit(cross(ahead, up), (1.0, 0.0, 0.0))
            over = cross(side, ahead)
            r = radii[i] if isinstance(radii, (list, tuple)) else radii
            rows.append([add(p, add(mul(side, r * math.cos(a)), mul(over, flat * r * math.sin(a))))
                         for a in (2 * math.pi * k / sides for k in range(sides))])
        self.grid(rows, material, closed=True)
        if lids:
            self.fan(rows[0], material, unit(sub(path[0], path[1])))
            self.fan(rows[-1], material, unit(sub(path[-1], path[-2])))
        return self

    def lathe(self, profile, material, axis=0, sides=24, middle=(0.0, 0.0, 0.0)):
        """Turns a profile of (along, radius) about an axis (0 x, 1 y, 2 z)."""
        u, v = (axis + 1) % 3, (axis + 2) % 3
        rows = []
        for along, radius in profile:
            row = []
            for k in range(sides):
                p = [0.0, 0.0, 0.0]
                p[axis] = along
                p[u] = radius * math.cos(2 * math.pi * k / sides)
                p[v] = radius * math.sin(2 * math.pi * k / sides)
                row.append(add(tuple(p), middle))
            rows.append(row)
        return self.grid(rows, material, closed=True)

    def ellipsoid(self, middle, radii, material, sides=20):
        rows = []
        for i in range(sides // 2 + 1):
            polar = math.pi * i / (sides // 2)
            rows.append([add(middle, (radii[0] * math.sin(polar) * math.cos(a), radii[1] * math.cos(polar),
                                      radii[2] * math.sin(polar) * math.sin(a)))
                         for a in (2 * math.pi * k / sides for k in range(sides))])
        return self.grid(rows, material, closed=True)

    def mirrored(self):
        """The twin on the other side of z = 0."""
        twin = Mesh()
        for material, (vertices, indices, _) in self.parts.items():
            for k in range(0, len(indices), 3):
                corners = [vertices[i] for i in indices[k:k + 3]]
                twin.triangle(material, [((p[0], p[1], -p[2]), (n[0], n[1], -n[2]), t)
                                         for p, n, t in reversed(corners)])
        return twin

    @staticmethod
    def _sum(points):
        return tuple(sum(p[i] for p in points) for i in range(3))

    @staticmethod
    def _facing(ring, middle):
        centre = mul(Mesh._sum(ring), 1.0 / len(ring))
        face = cross(sub(ring[1], ring[0]), sub(ring[3], ring[0]))
        return ring if dot(face, sub(centre, middle)) > 0 else ring[::-1]


class Node:
    def __init__(self, name, mesh=None, at=(0.0, 0.0, 0.0), turn=None, children=()):
        self.name, self.mesh, self.at, self.turn, self.children = name, mesh, at, turn, list(children)


def png(width, height, rows):
    """Rows of bytes (RGB, first row on top) as a PNG file."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


class Writer:
    """materials: name -> dict(color=(r, g, b[, a]) linear, rough, metal, emit, texture, blend, both)."""

    def __init__(self, materials, textures=None):
        self.materials, self.textures = materials, textures or {}
        self.binary = bytearray()
        self.gltf = {"asset": {"version": "2.0", "generator": "Luftpost assets/make/models.py"}, "scene": 0,
                     "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "accessors": [], "bufferViews": [],
                     "materials": [], "buffers": []}
        self.material_index = {}
        self.texture_index = {}

    def view(self, data, target=None):
        while len(self.binary) % 4:
            self.binary.append(0)
        entry = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            entry["target"] = target
        self.binary += data
        self.gltf["bufferViews"].append(entry)
        return len(self.gltf["bufferViews"]) - 1

    def accessor(self, data, kind, component, count, target, bounds=None):
        entry = {"bufferView": self.view(data, target), "componentType": component, "count": count, "type": kind}
        if bounds:
            entry["min"], entry["max"] = bounds
        self.gltf["accessors"].append(entry)
        return len(self.gltf["accessors"]) - 1

    def texture(self, name):
        if name not in self.texture_index:
            images = self.gltf.setdefault("images", [])
            images.append({"name": name, "mimeType": "image/png", "bufferView": self.view(self.textures[name])})
            self.gltf.setdefault("samplers", [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}])
            self.gltf.setdefault("textures", []).append({"source": len(images) - 1, "sampler": 0})
            self.texture_index[name] = len(images) - 1
        return self.texture_index[name]

    def material(self, name):
        if name not in self.material_index:
            m = self.materials[name]
            color = list(m["color"]) + ([1.0] if len(m["color"]) == 3 else [])
            pbr = {"baseColorFactor": color, "metallicFactor": m.get("metal", 0.0), "roughnessFactor": m.get("rough", 0.6)}
            if "texture" in m:
                pbr["baseColorTexture"] = {"index": self.texture(m["texture"])}
            entry = {"name": name, "pbrMetallicRoughness": pbr}
            if "emit" in m:
                entry["emissiveFactor"] = list(m["emit"])
            if m.get("blend"):
                entry["alphaMode"] = "BLEND"
            if m.get("both"):
                entry["doubleSided"] = True
            self.gltf["materials"].append(entry)
            self.material_index[name] = len(self.gltf["materials"]) - 1
        return self.material_index[name]

    def mesh(self, name, mesh):
        primitives = []
        for material, (vertices, indices, _) in mesh.parts.items():
            def pack(values, size):
                return b"".join(struct.pack("<%df" % size, *value) for value in values)
            positions = [tuple(struct.unpack("<3f", struct.pack("<3f", *v[0]))) for v in vertices]
            bounds = ([min(p[i] for p in positions) for i in range(3)], [max(p[i] for p in positions) for i in range(3)])
            count, wide = len(vertices), len(vertices) > 65535
            attributes = {"POSITION": self.accessor(pack(positions, 3), "VEC3", 5126, count, 34962, bounds),
                          "NORMAL": self.accessor(pack([v[1] for v in vertices], 3), "VEC3", 5126, count, 34962),
                          "TEXCOORD_0": self.accessor(pack([v[2] for v in vertices], 2), "VEC2", 5126, count, 34962)}
            data = struct.pack("<%d%s" % (len(indices), "I" if wide else "H"), *indices)
            primitives.append({"attributes": attributes, "material": self.material(material),
                               "indices": self.accessor(data, "SCALAR", 5125 if wide else 5123, len(indices), 34963)})
        self.gltf["meshes"].append({"name": name, "primitives": primitives})
        return len(self.gltf["meshes"]) - 1

    def node(self, node):
        entry = {"name": node.name}
        index = len(self.gltf["nodes"])
        self.gltf["nodes"].append(entry)
        if any(node.at):
            entry["translation"] = list(node.at)
        if node.turn:
            entry["rotation"] = list(node.turn)
        if node.mesh:
            entry["mesh"] = self.mesh(node.name, node.mesh)
        if node.children:
            entry["children"] = [self.node(child) for child in node.children]
        return index

    def save(self, path, roots):
        self.gltf["scenes"][0]["nodes"] = [self.node(root) for root in roots]
        while len(self.binary) % 4:
            self.binary.append(0)
        self.gltf["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.gltf, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        size = 12 + 8 + len(text) + 8 + len(self.binary)
        with open(path, "wb") as out:
            out.write(struct.pack("<III", 0x46546C67, 2, size) + struct.pack("<II", len(text), 0x4E4F534A) + text +
                      struct.pack("<II", len(self.binary), 0x004E4942) + bytes(self.binary))


def turn_about(axis, angle):
    """Quaternion x, y, z, w."""
    s = math.sin(angle / 2)
    return (axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2))
