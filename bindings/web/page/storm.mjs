// SPDX-License-Identifier: MIT
// The storm: one batch over a ground. Bodies respawn upwind and above at a given age or outside the storm.
import { LR } from './package/langevin_rigid.mjs';

const longest = 16; // s, largest age, in the air and on the ground
const random = (low, high) => low + (high - low) * Math.random();

export class Storm {
  #lr;
  #gusts;

  constructor(lr, asset, model, count) {
    this.#lr = lr;
    this.model = model;
    this.world = lr.createWorld({ seed: 2 });
    this.world.createCollider({ kind: LR.COLLIDER_PLANE, friction: 0.8 });
    this.world.addGroundWind({ roughnessLength: 0.003 * model.room[1], referenceHeight: model.room[1] });
    this.#gusts = this.world.addGusts({ rms: 0 });
    this.eddies = this.world.addTurbulence({ rms: 0, integralLength: 0.4 * model.room[0] });
    this.batch = this.world.createBatch({ asset, capacity: count });
    this.transforms = this.batch.createTransforms(LR.TRANSFORM_4X4_COLUMN_MAJOR);
    this.#fill(count);
  }

  /** Fills the storm with bodies of any age, as after a long time. */
  #fill(count) {
    const [half, height] = this.model.room;
    const position = new Float32Array(3 * count).map((_, i) => (i % 3 === 1 ? random(0.05 * height, height) : random(-half, half)));
    const orientation = new Float32Array(4 * count).map(() => random(-1, 1));
    const age = new Float32Array(count).map(() => random(0, longest));
    const scale = new Float32Array(count).map(() => random(0.8, 1.2));
    this.batch.createBodies({ count, position, orientation, age, scale });
  }

  setWind({ wind, gusts, direction }) {
    const { room: [half, height], fall } = this.model;
    const angle = (direction * Math.PI) / 180;
    const velocity = [wind * Math.cos(angle), 0, wind * Math.sin(angle)];
    this.world.setUniformWind(velocity);
    this.world.updateGusts(this.#gusts, { rms: gusts, direction: [Math.cos(angle), 0, Math.sin(angle)], angleRms: 0.4, integralTime: 3 });
    this.world.updateTurbulence(this.eddies, { rms: 0.4 * gusts, integralLength: 0.4 * half });
    // The wind carries bodies this far while they fall, so they must start this far upwind.
    const carried = velocity.map((v) => (0.6 * v * height) / fall);
    const reach = carried.map((c) => half + Math.abs(c) / 2);
    this.batch.setEmitter({
      shape: LR.EMIT_BOX, position: [-carried[0] / 2, 0.8 * height, -carried[2] / 2], size: [reach[0], 0.3 * height, reach[2]],
      scaleMin: 0.8, scaleMax: 1.2,
    });
    const room = reach.map((r) => 3 * r + 4 * half);
    this.batch.setRules({
      action: LR.END_RESPAWN, maxAge: longest,
      volumes: [{ shape: LR.VOLUME_BOX, side: LR.KILL_OUTSIDE, center: [0, 0, 0], size: [room[0], 3 * height, room[2]] }],
    });
  }

  step(dt) {
    this.world.step(dt, this.model.substeps);
  }

  dispose() {
    this.transforms.dispose();
    this.world.dispose();
  }
}

/** The baked asset, or a thin ellipsoid of the same size and mass. */
export function assetOf(lr, model) {
  if (model.file) return lr.fetchAsset(new URL(`models/${model.file}`, import.meta.url));
  const [x, y, z] = model.box;
  return Promise.resolve(lr.createEllipsoid({ semiAxes: [1.128 * x, 1.128 * y, 1.178 * z], density: model.density }));
}
