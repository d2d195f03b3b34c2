// SPDX-License-Identifier: MIT
// Compiled, never run: the types accept correct calls and refuse wrong ones.
import { Asset, Batch, LR, LangevinRigid, LangevinRigidError, World, load } from './langevin-rigid/langevin_rigid.mjs';

export async function right(): Promise<void> {
  const lr: LangevinRigid = await load({ wasm: new URL('x.wasm', 'http://localhost/') });
  const leaf: Asset = await lr.fetchAsset('leaf.lrb');
  const mass: number = leaf.info.mass;
  const content: bigint = leaf.info.contentHash;
  const world: World = lr.createWorld({ seed: 1n, gravity: new Float32Array(3), log: (level, message) => console.log(level + 1, message.length) });
  const batch: Batch = world.createBatch({ asset: leaf, capacity: 10, loadModel: LR.LOADS_AERODYNAMIC });
  const ids: BigUint64Array = batch.createBodies({ count: 2, position: [0, 1, 2, 3, 4, 5] });
  world.setWindCallback((query) => {
    query.velocity[0][0] = query.position[0][0] * mass;
  });
  world.addGusts({ rms: 1, direction: [1, 0, 0] });
  const circulation: number = world.vortex(world.addVortex({ core: LR.VORTEX_RANKINE })).circulation;
  world.setWater({ waves: [{ direction: [1, 0, 0], length: 1, amplitude: 0.1, phase: 0 }] });
  batch.setRules({ volumes: [{ shape: LR.VOLUME_BOX, side: LR.KILL_OUTSIDE, center: [0, 0, 0], size: [1, 1, 1] }] });
  world.createCollider({ kind: LR.COLLIDER_MESH, vertices: new Float32Array(9), indices: [0, 1, 2] });
  const hit = world.rayCast([{ origin: [0, 0, 0], batch }])[0];
  const at: number[] | undefined = hit?.position;
  const matrices: Float32Array = batch.createTransforms().write();
  const status: number = lr.raw.lr_world_step(0, 1, 1);
  console.log(content, circulation, ids, at, matrices, status, new Date() instanceof LangevinRigidError);
}

export async function wrong(lr: LangevinRigid, world: World, leaf: Asset): Promise<void> {
  // @ts-expect-error no such field
  lr.createWorld({ sead: 1 });
  // @ts-expect-error the module has no other threads, and its own memory
  lr.createWorld({ allocator: {} });
  // @ts-expect-error a batch needs an asset
  world.createBatch({ capacity: 1 });
  // @ts-expect-error ids are bigints
  world.bodyState(1);
  // @ts-expect-error constants are constant
  LR.OK = 1;
  // @ts-expect-error only loadAsset and similar functions create assets
  new Asset();
  // @ts-expect-error read only
  leaf.info = leaf.info;
  // @ts-expect-error pointers of 64 bits are bigints
  lr.raw.lr_asset_load_memory(0, 10, 0);
}
