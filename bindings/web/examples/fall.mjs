// SPDX-License-Identifier: MIT
// The first falling leaves, in node: node fall.mjs [leaf.lrb]
import { pathToFileURL } from 'node:url';
import { load, LR } from 'langevin-rigid';

const [, , file] = process.argv;
const lr = await load();
// The shape: an asset that lr_bake made from a mesh, or without a file an ellipsoid of 8 cm x 2 cm x 0.1 mm.
const leaf = file ? await lr.fetchAsset(pathToFileURL(file)) : lr.createEllipsoid({ semiAxes: [0.04, 0.01, 0.00005], density: 800 });
const { mass, density } = leaf.info;
console.log(`Langevin Rigid ${lr.version}, ${lr.simdTargetName(lr.simdTargets()[0])}: leaves of ${(1e3 * mass).toFixed(3)} g, ${density.toFixed(0)} kg/m^3`);

// A world with wind over a ground, and a batch: all bodies of one asset.
const world = lr.createWorld({ seed: 1 });
world.setUniformWind([1, 0, 0]);
world.addGusts({ rms: 0.5 });
world.createCollider({ kind: LR.COLLIDER_PLANE });
const count = 1000;
const batch = world.createBatch({ asset: leaf, capacity: count });

// Each leaf has its own position and orientation: arrays of x y z, and of quaternions.
const position = new Float32Array(3 * count).map((_, i) => (i % 3 === 1 ? 2 + (i % 7) / 2 : 0.1 * (i % 31)));
const orientation = new Float32Array(4 * count).map((_, i) => Math.sin(i));
const bodies = batch.createBodies({ count, position, orientation });

// Ten seconds of frames. An engine would upload `matrices` to the GPU in each frame; the array is in the module's memory.
const transforms = batch.createTransforms(LR.TRANSFORM_4X4_COLUMN_MAJOR);
let matrices;
for (let frame = 0; frame < 600; ++frame) {
  world.step(1 / 60, 2);
  matrices = transforms.write();
  if (frame % 120 === 119) {
    let height = 0;
    for (let i = 0; i < count; ++i) height += matrices[16 * i + 13] / count;
    console.log(`${world.info.time.toFixed(0)} s: mean height ${height.toFixed(2)} m, ${batch.view().awakeCount} in the air`);
  }
}
const { position: at, linearVelocity } = world.bodyState(bodies[0]);
console.log(`leaf 0 is at ${at.map((x) => x.toFixed(2))} m, with ${Math.hypot(...linearVelocity).toFixed(2)} m/s`);
console.log(`hash ${world.hash().toString(16)}`);

try {
  world.step(-1);
} catch (error) {
  console.log(`as expected: ${error.message}`);
}
world.dispose();
leaf.dispose();
