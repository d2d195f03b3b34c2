# SPDX-License-Identifier: MIT
"""USD and PC2 files, parsed by readers independent of the writers."""
import unittest

import numpy as np
import usda_reader
from support import ROOT, WORK, lr, thin_leaf

from langevin_rigid.export import read_pc2, write_carrier_pc2, write_usda
from langevin_rigid.mesh import Mesh
from langevin_rigid.view import turned


def storm(frames=12, fps=30.0):
    """Bodies spawn and end between frames."""
    recording = lr.Recording(fps=fps, first_frame=5)
    with lr.World(seed=9) as world:
        batch = world.create_batch(thin_leaf(), 40)
        batch.set_emitter(shape=lr.EmitterShape.BOX, size=(1, 1, 1), rate=60, speed_max=2, spin_max=9, scale_min=0.5, scale_max=2)
        batch.set_rules(max_age=0.2)
        for _ in range(frames):
            recording.capture(batch)
            world.step(1 / fps, 4)
    return recording


class Usd(unittest.TestCase):
    def setUp(self):
        self.recording, self.path = storm(), WORK / "storm.usda"
        self.mesh = Mesh.read_obj(ROOT / "assets" / "leaf.obj").moved((0, 0, 0.5))

    def test_what_is_read_is_what_was_recorded(self):
        write_usda(self.path, self.recording, self.mesh, up_axis="Z")
        stage = usda_reader.read(self.path)
        meta = stage.metadata
        self.assertEqual((meta["defaultPrim"], meta["upAxis"], meta["metersPerUnit"]), ("Storm", "Z", 1))
        self.assertEqual((meta["startTimeCode"], meta["endTimeCode"], meta["timeCodesPerSecond"]), (5, 16, 30))
        instancer = stage.at("/Storm/Bodies")
        self.assertEqual(instancer.kind, "PointInstancer")
        self.assertEqual(stage.at(instancer.relationships["prototypes"]).kind, "Mesh")
        types = {"protoIndices": "int[]", "ids": "int64[]", "positions": "point3f[]", "orientations": "quath[]",
                 "scales": "float3[]", "velocities": "vector3f[]", "angularVelocities": "vector3f[]", "extent": "float3[]"}
        self.assertEqual({name: a["type"] for name, a in instancer.attributes.items()}, types)
        spawned = 0
        for number, frame in zip(self.recording.frame_numbers, self.recording):
            got = {name: np.array(a["value"][number]) for name, a in instancer.attributes.items()}
            n = len(frame.ids)
            spawned += n
            for name in set(types) - {"extent"}:
                self.assertEqual(len(got[name]), n, name)
            self.assertEqual(got["extent"].shape, (2, 3))
            np.testing.assert_array_equal(got["ids"], frame.ids)
            if n:
                np.testing.assert_allclose(got["positions"].astype(np.float32), frame.position, rtol=1e-7)
                np.testing.assert_allclose(got["scales"], np.repeat(frame.scale[:, None], 3, 1), rtol=1e-6)
                np.testing.assert_allclose(got["velocities"], frame.velocity, rtol=1e-6)
                np.testing.assert_allclose(got["angularVelocities"], np.degrees(frame.spin), rtol=1e-6)
                halves = got["orientations"].astype(np.float16).astype(np.float64)[:, [1, 2, 3, 0]]
                half_turns = 2 * np.degrees(np.linalg.norm(halves - frame.orientation, axis=1))
                self.assertLess(half_turns.max(), 0.1)
                corners = frame.position[:, None] + frame.scale[:, None, None] * turned(
                    np.repeat(frame.orientation[:, None], len(self.mesh.points), 1),
                    np.repeat(self.mesh.points[None].astype(np.float32), n, 0))
                self.assertTrue((corners >= got["extent"][0] - 1e-4).all() and (corners <= got["extent"][1] + 1e-4).all())
        self.assertGreater(spawned, 50)
        drawn = stage.at("/Storm/Bodies/Prototype").attributes
        np.testing.assert_allclose(drawn["points"]["value"], self.mesh.points, rtol=1e-8, atol=1e-12)
        self.assertEqual(drawn["faceVertexIndices"]["value"], self.mesh.indices.tolist())
        self.assertEqual(sum(drawn["faceVertexCounts"]["value"]), len(drawn["primvars:st"]["value"]))
        self.assertEqual((drawn["primvars:st"]["interpolation"], drawn["subdivisionScheme"]["value"]), ("faceVarying", "none"))

    def test_several_recordings(self):
        write_usda(self.path, [(self.recording, self.mesh), (storm(5), self.mesh)], names=["oak leaves", "oak leaves"])
        stage = usda_reader.read(self.path)
        self.assertEqual(list(stage.at("/Storm").children), ["oak_leaves", "oak_leaves_2"])
        self.assertEqual(stage.metadata["endTimeCode"], 16)

    def test_what_cannot_be_written_is_refused(self):
        for call in (lambda: write_usda(self.path, self.recording), lambda: write_usda(self.path, self.recording, self.mesh, up_axis="X"),
                     lambda: write_usda(self.path, lr.Recording(), self.mesh),
                     lambda: write_usda(self.path, [(self.recording, self.mesh), (storm(3, 25), self.mesh)])):
            with self.assertRaises((TypeError, ValueError)):
                call()

    def test_the_reader_refuses_what_is_wrong(self):
        write_usda(self.path, self.recording, self.mesh)
        text = self.path.read_text()
        for old, new in (("quath[]", "quatz[]"), ("int64[] ids", "int[ ids"), ("#usda 1.0", "#usda"), ("    6: [", "    5: [")):
            self.assertIn(old, text)
            with self.assertRaises((ValueError, KeyError)):
                usda_reader.Reader(text.replace(old, new, 1)).stage()


class PointCache(unittest.TestCase):
    def test_the_carrier_has_every_body(self):
        recording, path = storm(20), WORK / "storm.pc2"
        cache = write_carrier_pc2(path, recording)
        start, rate, samples = read_pc2(path)
        slots, count = recording.slots()
        self.assertEqual((start, rate, samples.shape), (5, 1, (20, 3 * count, 3)))
        self.assertEqual(cache.vertices, 3 * count)
        np.testing.assert_array_equal(cache.first, samples[0])
        self.assertEqual(path.stat().st_size, 32 + samples.nbytes)
        triads = samples.reshape(20, count, 3, 3)
        for at, (frame, slot) in enumerate(zip(recording, slots)):
            centre, x, y = (triads[at, slot, i] for i in range(3))
            np.testing.assert_allclose(centre, frame.position)
            np.testing.assert_allclose(np.linalg.norm(x - centre, axis=1), frame.scale, rtol=1e-5)
            axes = np.stack([turned(frame.orientation, np.broadcast_to(a, centre.shape)) for a in np.eye(3, dtype=np.float32)], 1)
            got = np.stack([x - centre, y - centre, np.cross(x - centre, y - centre) / frame.scale[:, None]], 1)
            np.testing.assert_allclose(got / frame.scale[:, None, None], axes, atol=1e-5)
            empty = np.setdiff1d(np.arange(count), slot)
            self.assertEqual(np.abs(triads[at, empty] - triads[at, empty, :1]).max(initial=0), 0)
            self.assertTrue(np.isfinite(triads[at]).all())
        # Before a spawn and after an end the slot is at that place: nothing crosses the scene between two frames.
        for s in range(count):
            alive = np.array([s in slot for slot in slots])
            for at in range(19):
                if alive[at] != alive[at + 1]:
                    np.testing.assert_array_equal(triads[at, s, 0], triads[at + 1, s, 0])


if __name__ == "__main__":
    unittest.main()
