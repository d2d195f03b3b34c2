// SPDX-License-Identifier: MIT
// The storm of storm.c in JavaScript. node storm.mjs PACKAGE leaf.lrb BODIES FRAMES: prints hash and ns per body-step in the same form.
import { pathToFileURL } from 'node:url';

export function storm(lr, LR, leaf, bodies) {
  const world = lr.createWorld({ seed: 7 });
  const batch = world.createBatch({ asset: leaf, capacity: bodies });
  world.setUniformWind([2, 0, 0]);
  world.addGusts();
  world.createCollider({ kind: LR.COLLIDER_PLANE });
  const position = new Float32Array(3 * bodies);
  const orientation = new Float32Array(4 * bodies);
  for (let i = 0; i < bodies; ++i) {
    position.set([0.25 * (i % 100), 0.5 + 0.25 * (Math.floor(i / 100) % 20), 0.25 * Math.floor(i / 2000)], 3 * i);
    orientation.set([0.5, 0, 0, 1], 4 * i);
  }
  batch.createBodies({ count: bodies, position, orientation });
  return { world, batch };
}

export const hex = (hash) => hash.toString(16).padStart(16, '0');

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const [, , directory, file, bodies, frames] = process.argv;
  const { load, LR } = await import(`${pathToFileURL(directory)}/langevin_rigid.mjs`);
  const lr = await load();
  const leaf = await lr.fetchAsset(pathToFileURL(file));
  const { world } = storm(lr, LR, leaf, Number(bodies));
  let least = Infinity;
  for (let frame = 0; frame < Number(frames);) {
    const since = performance.now();
    const end = Math.min(frame + 10, Number(frames));
    const counted = end - frame;
    for (; frame < end; ++frame) world.step(1 / 64, 2);
    least = Math.min(least, (performance.now() - since) / counted);
  }
  const ns = (1e6 * least) / Number(bodies);
  console.log(hex(world.hash()), ns.toFixed(1), lr.simdTargetName(world.info.simdTarget));
}
