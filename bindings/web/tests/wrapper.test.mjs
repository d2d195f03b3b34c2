// SPDX-License-Identifier: MIT
// The delivered package in node. LR_PACKAGE: its folder; LR_LEAF: an asset; LR_NATIVE: output of storm.c; LR_SNAPSHOT: its snapshot file.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

import { hex, storm } from './storm.mjs';

const from = (name) => import(`${pathToFileURL(process.env.LR_PACKAGE)}/${name}`);
const { load, LR, LangevinRigidError, Asset, World, Batch, TransformBuffer } = await from('langevin_rigid.mjs');
const { functions, structs, headerVersion } = await from('src/generated/api.mjs');
const lr = await load();
const leafBytes = await readFile(process.env.LR_LEAF);
const leaf = lr.loadAsset(leafBytes);
const refused = (name, said) => (error) => {
  assert.ok(error instanceof LangevinRigidError, String(error));
  assert.equal(error.statusName, `LR_ERROR_${name}`);
  assert.equal(error.status, LR[`ERROR_${name}`]);
  if (said) assert.match(error.message, said);
  return true;
};
const scene = (desc = {}, capacity = 100) => {
  const world = lr.createWorld(desc);
  return { world, batch: world.createBatch({ asset: leaf, capacity }) };
};

test('the module is of this header, with SIMD, and has every function', () => {
  assert.equal(lr.raw.lr_version(), headerVersion);
  assert.deepEqual(lr.simdTargets(), [LR.SIMD_WASM]);
  assert.equal(lr.simdTargetName(LR.SIMD_WASM), 'WebAssembly');
  assert.match(lr.version, /^\d+\.\d+\.\d+$/);
  for (const name of functions) assert.equal(typeof lr.raw[name], 'function', name);
});

test('every C function is called by the wrapper', async () => {
  const files = ['langevin_rigid.mjs', ...['asset', 'batch', 'generated/plain', 'host', 'world'].map((name) => `src/${name}.mjs`)];
  const source = (await Promise.all(files.map((file) => readFile(`${process.env.LR_PACKAGE}/${file}`, 'utf8')))).join('\n');
  // Wind sources: a call's name is built from verb and kind.
  const kinds = /for \(const kind of (\[.*?\])\)/s.exec(source)[1].match(/\w+/g);
  const stems = [...source.matchAll(/`(lr_world_\w+_)\$\{kind\}`/g)].map(([, stem]) => stem);
  const built = new Set(stems.flatMap((stem) => kinds.map((kind) => stem + kind)));
  const without = new Set(['lr_asset_load_file']); // the module has no files; fetchAsset replaces it
  const missing = functions.filter((name) => !without.has(name) && !name.endsWith('_init') && !source.includes(name) && !built.has(name));
  assert.deepEqual(missing, []);
});

test('recordings', () => {
  const { world, batch } = scene({}, 20);
  const pieces = [];
  assert.throws(() => world.stopRecording(), refused('INVALID_ARGUMENT'));
  world.startRecording((bytes) => pieces.push(bytes), { hashInterval: 2 });
  batch.createBodies([{}, {}]);
  world.step(1 / 60);
  world.stopRecording();
  const length = () => pieces.reduce((sum, piece) => sum + piece.length, 0);
  const before = length();
  assert.ok(before > 1000);
  world.step(1 / 60);
  assert.equal(length(), before);
  assert.throws(() => world.startRecording(() => { throw new RangeError('no room'); }), /no room/);
  world.step(1 / 60);
  // A call in which the recording fails has taken effect.
  let [full, asked] = [false, 0];
  world.startRecording(() => { if (full) throw new RangeError('full'); });
  full = true;
  assert.throws(() => world.setWindCallback(() => { ++asked; }), /full/);
  world.step(1 / 60);
  assert.ok(asked > 0);
  world.dispose();
});

test('an exception of a callback loses no handle', () => {
  const creations = {
    batch: (world) => { const batch = world.createBatch({ asset: leaf, capacity: 1 }); return () => world.batchIsValid(batch); },
    body: (world, batch) => { const body = batch.createBody(); return () => world.bodyIsValid(body); },
    box: (world, batch) => { const [, body] = batch.spawnBox([0, 0, 0], [1, 1, 1], 2); return () => world.bodyIsValid(body); },
    emitter: (world, batch) => { const [, body] = batch.emit(2); return () => world.bodyIsValid(body); },
    collider: (world) => { const id = world.createCollider({ kind: LR.COLLIDER_PLANE }); return () => world.colliderIsValid(id); },
    wind: (world) => { const id = world.addVortex(); return () => world.windSourceIsValid(id); },
  };
  for (const [name, create] of Object.entries(creations)) {
    const { world, batch } = scene({}, 20);
    batch.setEmitter({});
    let full = false;
    const record = () => {
      full = false;
      world.startRecording(() => { if (full) throw new RangeError('full'); });
      full = true;
    };
    record();
    const isValid = create(world, batch);
    assert.throws(() => world.step(1 / 60), /full/, name);
    assert.ok(isValid(), name);
    record();
    create(world, batch);
    assert.throws(() => world.dispose(), /full/, name);
  }
});

test('struct layouts are those of the module', () => {
  for (const [name, { size, init, fields }] of Object.entries(structs)) {
    if (!init) continue;
    const at = lr.raw.malloc(size + 8);
    new Uint8Array(lr.memory.buffer, at, size + 8).fill(0xab);
    assert.equal(lr.raw[init](at, size), LR.OK, name);
    assert.equal(new DataView(lr.memory.buffer).getUint32(at, true), size, name);
    assert.equal(lr.raw[init](at, size - 1), LR.ERROR_STRUCT_SIZE, `${name}: a byte less`);
    assert.deepEqual([...new Uint8Array(lr.memory.buffer, at + size, 8)], Array(8).fill(0xab), `${name} ends there`);
    assert.ok(fields.length > 0);
    lr.raw.free(at);
  }
  assert.deepEqual(lr.initial('lr_world_desc').gravity.map((g) => Math.round(100 * g)), [0, -981, 0]);
  assert.equal(lr.initial('lr_water_desc').density, 998);
  assert.equal(lr.initial('lr_emitter_desc').scaleMax, 1);
  assert.deepEqual(lr.initial('lr_collider_desc').orientation, [0, 0, 0, 1]);
});

test('assets: properties, references, faults', async () => {
  const { info } = leaf;
  assert.equal(Math.round(info.density), 350);
  assert.ok(info.mass > 0 && info.hullVertexCount > 0 && info.addedMass.length === 36 && typeof info.contentHash === 'bigint');
  assert.equal(info.name, 'leaf');
  assert.equal((await lr.fetchAsset(pathToFileURL(process.env.LR_LEAF))).info.contentHash, info.contentHash);
  const copy = leaf.clone();
  copy.dispose();
  copy.dispose();
  assert.throws(() => copy.info, /disposed/);
  assert.equal(leaf.info.mass, info.mass);
  assert.ok(Math.max(...leaf.aerodynamics.drag) > 0);
  const damaged = new Uint8Array(leafBytes);
  damaged[200] ^= 1;
  assert.deepEqual(lr.checkAsset(leafBytes), []);
  const [fault] = lr.checkAsset(damaged);
  assert.ok(fault.number > 0 && fault.remedy.length > 0);
  assert.throws(() => lr.loadAsset(damaged), refused('ASSET_CORRUPT', new RegExp(`fault ${fault.number}`)));
  assert.throws(() => lr.loadAsset(new Uint8Array(3)), refused('ASSET_FORMAT'));
  assert.throws(() => lr.loadAsset('leaf.lrb'), TypeError);
  const paper = lr.createRigid({ mass: 0.001, volume: 1e-5, inertia: [1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6], extents: [0.1, 0.1, 0.001], aerodynamics: leaf.aerodynamics });
  assert.equal(paper.info.mass, 0.001);
  assert.deepEqual(paper.aerodynamics.drag, leaf.aerodynamics.drag);
  assert.throws(() => lr.createEllipsoid({ semiAxes: [0, 1, 1], density: 1 }), refused('INVALID_ARGUMENT'));
  await assert.rejects(lr.fetchAsset(new URL('nowhere.lrb', import.meta.url)), /nowhere/);
});

test('errors name function, status and reason; wrong values are refused', () => {
  const { world, batch } = scene();
  assert.throws(() => world.step(-1), refused('TIMESTEP_NEGATIVE', /lr_world_step/));
  assert.throws(() => world.step(0), refused('TIMESTEP_ZERO'));
  assert.throws(() => world.step(1 / 60, 0), refused('SUBSTEPS'));
  assert.throws(() => lr.createWorld({ workerCount: 2 }), refused('THREADS'));
  assert.throws(() => lr.createWorld({ simdTarget: LR.SIMD_AVX2 }), refused('UNSUPPORTED'));
  assert.throws(() => lr.createWorld({ sead: 1 }), /no field sead; it has .*seed/);
  assert.throws(() => lr.createWorld({ seed: -1 }), RangeError);
  assert.throws(() => lr.createWorld({ seed: 1.5 }), RangeError);
  assert.throws(() => lr.createWorld({ gravity: [0, -9] }), /gravity must have 3 elements/);
  assert.throws(() => lr.createWorld({ gravity: [0, NaN, 0] }), refused('NOT_FINITE'));
  assert.throws(() => world.createBatch({ capacity: 1 }), /needs an asset/);
  assert.throws(() => world.createBatch({ asset: leaf, capacity: '10' }), TypeError);
  assert.throws(() => world.createBatch({ asset: leaf, capacity: 0 }), refused('INVALID_ARGUMENT'));
  const body = batch.createBody();
  assert.ok(world.bodyIsValid(body) && !world.bodyIsValid(0n));
  world.destroyBodies(body);
  assert.ok(!world.bodyIsValid(body));
  const collider = world.createCollider({ kind: LR.COLLIDER_PLANE });
  assert.ok(world.colliderIsValid(collider));
  world.destroyColliders(collider);
  assert.ok(!world.colliderIsValid(collider));
  assert.throws(() => world.bodyState(body), refused('STALE_BODY'));
  assert.throws(() => world.destroyBodies([body]), refused('STALE_BODY'));
  assert.throws(() => batch.createBodies({ count: 101 }), refused('CAPACITY'));
  assert.throws(() => batch.createBodies(), /needs an array of objects/);
  for (const wrong of [-1, 1.5, '5', NaN, undefined, 2 ** 32]) {
    assert.throws(() => batch.createBodies({ count: wrong }), /createBodies needs|count must be a whole number/, String(wrong));
    assert.throws(() => batch.emit(wrong), /count must be a whole number/, String(wrong));
    assert.throws(() => batch.spawnBox([0, 0, 0], [1, 1, 1], wrong), /count must be a whole number/, String(wrong));
    assert.throws(() => world.setEvents(wrong), /capacity must be a whole number/, String(wrong));
    if (wrong === undefined) continue;
    assert.throws(() => batch.setRate(wrong), /divisor must be a whole number/, String(wrong));
    assert.throws(() => (batch.divergencePolicy = wrong), /policy must be a whole number/, String(wrong));
    if (wrong !== 2 ** 32) assert.throws(() => world.setBudget(wrong), /bodySubsteps must be a whole number/, String(wrong));
    assert.throws(() => world.step(1 / 60, wrong), /substeps must be a whole number/, String(wrong));
    assert.throws(() => batch.createTransforms(LR.TRANSFORM_4X4_ROW_MAJOR, wrong), /capacity must be a whole number/, String(wrong));
  }
  for (const call of ['createColliders', 'moveColliders', 'addForces', 'rayCast']) assert.throws(() => world[call]({}), /must be an array, not object/, call);
  assert.throws(() => batch.createBodies({ count: 2, position: [0] }), /6 elements, not 1/);
  assert.throws(() => batch.createBodies({ count: 1, speed: [0] }), /no speed/);
  assert.ok(world.batchIsValid(batch));
  batch.destroy();
  assert.ok(!world.batchIsValid(batch));
  assert.throws(() => batch.view(), refused('STALE_BATCH'));
  world.dispose();
  world.dispose();
  assert.throws(() => world.step(1 / 60), /disposed/);
  assert.equal(lr.statusString(LR.ERROR_THREADS), 'the worker threads could not be started');
});

test('bodies: created singly and many at once, read, set, pushed, asleep', () => {
  const { world, batch } = scene({ gravity: [0, 0, 0] });
  const single = batch.createBody({ position: [1, 2, 3], noiseSeed: 9, scale: 2 });
  const many = batch.createBodies({ count: 3, position: [0, 0, 0, 1, 0, 0, 2, 0, 0], scale: [1, 2, 3], noiseSeed: [5, 6, 7] });
  const objects = batch.createBodies([{ position: [5, 5, 5] }, { orientation: [1, 0, 0, 0] }]);
  assert.equal(world.info.bodyCount, 6);
  assert.equal(typeof single, 'bigint');
  const state = world.bodyState(single);
  assert.deepEqual(state.position, [1, 2, 3]);
  assert.deepEqual([state.noiseSeed, state.scale], [9, 2]);
  assert.deepEqual(world.bodyState(many[2]).position, [2, 0, 0]);
  assert.deepEqual([...many].map((id) => world.bodyState(id).noiseSeed), [5, 6, 7]);
  assert.deepEqual(world.bodyState(many[1]).orientation, [0, 0, 0, 1]);
  assert.deepEqual(world.bodyState(objects[1]).orientation, [1, 0, 0, 0]);
  world.setBodyState(single, { linearVelocity: [0, 1, 0] });
  assert.deepEqual(world.bodyState(single).linearVelocity.map(Math.fround), [0, 1, 0]);
  assert.deepEqual(world.bodyState(single).position, [1, 2, 3]);
  world.addForces([{ body: many[0], mode: LR.FORCE_MODE_VELOCITY, force: [3, 0, 0] }]);
  assert.ok(Math.abs(world.bodyState(many[0]).linearVelocity[0] - 3) < 1e-5);
  batch.addForces({ mode: LR.FORCE_MODE_VELOCITY, first: 1, force: [[1, 1], [0, 0], [0, 0]] });
  const velocities = batch.velocities(), { ids } = batch.view();
  assert.equal(velocities.length, 36);
  assert.ok(Math.abs(velocities[6 * 2] - 1) < 1e-5 && Math.abs(velocities[6 * 3]) < 1e-5);
  ids.forEach((id, i) => {
    const { linearVelocity, angularVelocity } = world.bodyState(id);
    assert.deepEqual([...velocities.subarray(6 * i, 6 * i + 6)], [...linearVelocity, ...angularVelocity]);
  });
  assert.throws(() => batch.addForces({ force: [[1], [1, 2], [1]] }), RangeError);
  batch.setForce({ acceleration: [0, 1, 0] });
  world.setSleep(many, true);
  assert.equal(batch.view().awakeCount, 3);
  assert.equal(world.wakeBox([-10, -10, -10], [10, 10, 10]), 3);
  world.step(1 / 60);
  batch.setForce(null);
  world.destroyBodies(many);
  assert.equal(batch.view().count, 3);
  world.dispose();
});

test('wind, water and their callbacks', () => {
  const { world, batch } = scene({ gravity: [0, 0, 0] });
  batch.createBodies({ count: 4, position: [0, 5, 0, 1, 5, 0, 2, 5, 0, 3, -5, 0] });
  world.setUniformWind([2, 0, 0]);
  assert.deepEqual(world.uniformWind, [2, 0, 0]);
  assert.deepEqual([...world.sampleWind([0, 0, 0, 1, 1, 1])], [2, 0, 0, 2, 0, 0]);
  const source = world.addWindGrid({ counts: [2, 1, 1], samples: [0, 1, 0, 0, 3, 0], outside: LR.WIND_OUTSIDE_CLAMP });
  assert.deepEqual([...world.sampleWind([0.5, 0, 0])], [2, 2, 0]);
  assert.throws(() => world.addWindGrid({ counts: [2, 1, 1], samples: [1] }), /6 numbers, not 1/);
  world.updateWindGrid(source, { counts: [2, 1, 1], position: [1, 0, 0] });
  assert.deepEqual([...world.windGrid(source).position], [1, 0, 0]);
  world.updateWindGrid(source, { ...world.windGrid(source), position: [2, 0, 0] }); // what was read says: keep the samples
  assert.deepEqual([...world.sampleWind([2.5, 0, 0])], [2, 2, 0]);
  assert.throws(() => world.vortex(source), refused('INVALID_ARGUMENT'));
  for (const kind of ['Gusts', 'Vortex', 'Blower', 'Turbulence', 'GroundWind']) world.removeWind(world[`add${kind}`]());
  world.removeWind(source);
  assert.ok(!world.windSourceIsValid(source));
  assert.throws(() => world.removeWind(source), refused('STALE_WIND_SOURCE'));
  let asked = 0;
  world.setWindCallback((query) => {
    asked += query.count;
    assert.equal(query.batch, batch.handle);
    for (let i = 0; i < query.count; ++i) {
      assert.ok(Math.abs(query.position[1][i]) <= 6);
      query.velocity[2][i] = 4;
    }
  });
  for (let i = 0; i < 30; ++i) world.step(1 / 60, 2);
  assert.equal(asked, 4 * 60);
  assert.ok(batch.view().position[2][0] > 0.3, 'bodies are carried along');
  const before = world.hash();
  world.setWindCallback(() => {
    throw new Error('of the callback');
  });
  assert.throws(() => world.step(1 / 60), /of the callback/);
  assert.notEqual(world.hash(), before);
  world.setWindCallback(null);
  world.setWater({ density: 1000, reach: 1, waves: [{ direction: [1, 0, 0], length: 5, amplitude: 0.1 }] });
  let wet = 0;
  world.setWaterCallback((query) => {
    wet += query.height.length + query.normal[0].length - query.count;
  });
  world.step(1 / 60);
  assert.ok(wet > 0);
  world.setWaterCallback(null);
  world.setWater(null);
  world.setUniformWind([0, 0, 0]);
  world.dispose();
});

test('callbacks cannot use their own world, and other worlds are told apart', async () => {
  const { world, batch } = scene(), other = scene();
  batch.createBody();
  other.batch.createBody();
  const refusals = new Set();
  const misuse = [() => world.step(1 / 60), () => batch.createBody(), () => batch.view(), () => world.saveSnapshot(), () => world.dispose()];
  world.setWindCallback(() => {
    for (const use of misuse) assert.throws(use, (error) => refusals.add(error.message).size > 0);
    other.world.step(1 / 60);
  });
  world.step(1 / 60, 1);
  assert.deepEqual([...refusals], ['a call on this world is running: its own callbacks cannot use it']);
  assert.equal(other.world.info.substepCount, 2);
  assert.throws(() => world.setBodyContact(batch, other.batch, true), /another world/);
  assert.throws(() => world.bodyContact(other.batch, batch), /another world/);
  assert.throws(() => world.overlap({ size: [-1, 1, 1] }), /lr_world_overlap: .*size/);
  const stranger = (await load()).createEllipsoid({ semiAxes: [0.04, 0.01, 5e-5], density: 800 });
  assert.throws(() => world.createBatch({ asset: stranger, capacity: 1 }), /another load/);
  world.dispose();
  other.world.dispose();
});

test('colliders, events, rays and overlaps', () => {
  const { world, batch } = scene();
  const [ground, hull, field, mesh] = world.createColliders([
    { kind: LR.COLLIDER_PLANE },
    { kind: LR.COLLIDER_HULL, position: [50, 0, 0], vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] },
    { kind: LR.COLLIDER_HEIGHTFIELD, position: [100, 0, 0], counts: [2, 3], heights: [0, 1, 2, 3, 4, 5] },
    { kind: LR.COLLIDER_MESH, position: [150, 0, 0], vertices: [0, 0, 0, 1, 0, 0, 0, 0, 1], indices: [0, 1, 2] },
  ]);
  assert.throws(() => world.createCollider({ kind: LR.COLLIDER_HEIGHTFIELD, counts: [2, 3], heights: [0] }), /6 heights, not 1/);
  assert.equal(world.info.colliderCount, 4);
  assert.equal(world.colliderState(field).kind, LR.COLLIDER_HEIGHTFIELD);
  world.moveColliders([{ collider: hull, mode: LR.MOVE_PLACE, position: [60, 0, 0] }]);
  assert.deepEqual(world.colliderState(hull).position, [60, 0, 0]);
  world.setColliderMaterial([ground, mesh], { friction: 2 });
  assert.equal(world.colliderState(mesh).friction, 2);
  batch.setContact({ friction: 1 });
  assert.equal(batch.contact.friction, 1);
  world.setBodyContact(batch, batch, true);
  assert.equal(world.bodyContact(batch, batch), true);
  world.setBodyContact(batch, batch, false);
  world.setEvents(100);
  const body = batch.createBody({ position: [0, 0.3, 0] });
  const begun = [];
  for (let i = 0; i < 200; ++i) {
    world.step(1 / 60);
    begun.push(...world.events().events.filter((event) => event.kind === LR.EVENT_HIT));
  }
  assert.ok(begun.length > 0 && begun[0].body === body && begun[0].collider === ground && begun[0].normal[1] > 0.99, String(begun.length));
  const [down, up] = world.rayCast([{ origin: [3, 10, 0], direction: [0, -1, 0] }, { origin: [3, 10, 0], direction: [0, 1, 0], batch }]);
  assert.equal(down.collider, ground);
  assert.ok(Math.abs(down.distance - 10) < 1e-3);
  assert.equal(up, null);
  assert.deepEqual([...world.overlap({ size: [1, 0, 0], position: world.bodyState(body).position, batch })], [body]);
  const more = batch.createBodies({ count: 99, position: new Float32Array(3 * 99).fill(30), user: new BigUint64Array(99).fill(7n) });
  assert.equal(world.bodyState(more[98]).user, 7n);
  assert.equal(batch.view().user.filter((user) => user === 7n).length, 99);
  assert.ok(batch.bounds().high[0] > 30 && batch.bounds().high[0] < 31);
  assert.equal(world.overlap({ size: [1, 0, 0], position: [30, 30, 30] }).length, more.length);
  world.destroyColliders(mesh);
  assert.throws(() => world.colliderState(mesh), refused('STALE_COLLIDER'));
  world.dispose();
});

test('rules, emitters, rates, budgets, gains, tables', () => {
  const { world, batch } = scene();
  batch.setEmitter({ shape: LR.EMIT_BOX, position: [0, 10, 0], size: [5, 0, 5], rate: 60 });
  batch.setRules({ action: LR.END_RESPAWN, maxAge: 0.5, volumes: [{ shape: LR.VOLUME_PLANE, side: LR.KILL_INSIDE, center: [0, -50, 0], size: [0, 1, 0] }] });
  world.setEvents(1000);
  assert.equal(batch.emit(2).length, 2);
  assert.equal(batch.spawnBox([-1, 9, -1], [1, 10, 1], 1).length, 1);
  assert.throws(() => batch.spawnBox([0, 1, 0], [0, 0, 0], 1), refused('INVALID_ARGUMENT'));
  let spawned = 3;
  let ended = 0;
  for (let i = 0; i < 60; ++i) {
    world.step(1 / 60);
    const { counts } = batch;
    const { events } = world.events();
    assert.equal(events.filter((event) => event.kind === LR.EVENT_SPAWNED).length, counts.spawned + (i === 0 ? 3 : 0));
    assert.equal(events.filter((event) => event.kind === LR.EVENT_RESPAWNED).length, counts.respawned);
    spawned += counts.spawned;
    ended += counts.respawned;
  }
  assert.equal(batch.counts.totalSpawned, spawned);
  assert.ok(spawned > 55 && ended > 20, `${spawned} ${ended}`);
  assert.deepEqual([batch.emitter.rate, batch.rules.maxAge, batch.rules.volumeCount], [60, 0.5, 1]);
  batch.setRules(null);
  batch.setEmitter(null);
  assert.deepEqual([batch.emitter, batch.rules, world.water], [null, null, null]);
  world.setWater({ density: 1025 });
  assert.equal(world.water.density, 1025);
  world.setWater(null);
  assert.ok(world.timings.total > 0);
  assert.equal(batch.divergencePolicy, LR.DIVERGENCE_AUTO);
  batch.divergencePolicy = LR.DIVERGENCE_FREEZE;
  assert.equal(batch.divergencePolicy, LR.DIVERGENCE_FREEZE);
  assert.throws(() => (batch.divergencePolicy = 7), refused('INVALID_ARGUMENT'));
  assert.equal(batch.counts.totalDiverged, 0);
  batch.setRate(4);
  assert.equal(batch.pace.divisor, 4);
  batch.setRate(1);
  world.setBudget(10);
  world.step(1 / 60);
  assert.ok(world.stepReport.bodySubstepsWanted > 10);
  world.setBudget(0);
  assert.equal(world.info.budget, 0);
  batch.setLoadGains({ drag: 2 });
  assert.equal(batch.loadGains.drag, 2);
  batch.setForce({ force: [0, 0.5, 0] });
  assert.deepEqual(batch.force.force, [0, 0.5, 0]);
  batch.setForce(null);
  const stronger = { ...batch.aerodynamics, intensity: 0 };
  batch.setAerodynamics(stronger);
  assert.equal(batch.aerodynamics.intensity, 0);
  batch.setAerodynamics(null);
  const own = batch.turbulenceTable;
  batch.setTurbulenceTable({ chi: [1, 2], epsilon: [1, 1], dt: 0.25, u0: 1, l: 0.5, stationary: 1 });
  const table = batch.turbulenceTable;
  assert.deepEqual({ ...table, chi: [...table.chi], epsilon: [...table.epsilon] },
    { chi: [1, 2], epsilon: [1, 1], dt: 0.25, u0: 1, l: 0.5, c0: 6.5, stationary: 1 });
  batch.setTurbulenceTable(table);
  assert.throws(() => batch.setTurbulenceTable({ chi: [1], epsilon: [1, 1] }), RangeError);
  batch.setTurbulenceTable(null);
  assert.deepEqual(batch.turbulenceTable, own);
  world.setGravity([0, -1.6, 0]);
  world.setSimdTarget(LR.SIMD_WASM);
  assert.throws(() => world.setSimdTarget(LR.SIMD_NEON), refused('UNSUPPORTED'));
  world.dispose();
});

test('hash and snapshot equal those of the native library', async () => {
  const [native] = (await readFile(process.env.LR_NATIVE, 'utf8')).split('\n');
  const [expected, , , bodies, frames] = [...native.split(' ').slice(0, 3), 2000, 60];
  const { world } = storm(lr, LR, leaf, bodies);
  for (let frame = 0; frame < frames; ++frame) world.step(1 / 64, 2);
  assert.equal(hex(world.hash()), expected);
  const theirs = new Uint8Array(await readFile(process.env.LR_SNAPSHOT));
  assert.ok(Buffer.from(world.saveSnapshot()).equals(Buffer.from(theirs)), 'the same bytes');
  const other = storm(lr, LR, leaf, bodies).world;
  assert.notEqual(hex(other.hash()), expected);
  other.restoreSnapshot(theirs.buffer);
  assert.equal(hex(other.hash()), expected);
  world.step(1 / 64);
  other.step(1 / 64);
  assert.equal(other.hash(), world.hash());
  theirs[100] ^= 1;
  assert.throws(() => other.restoreSnapshot(theirs), refused('SNAPSHOT_FORMAT'));
  assert.throws(() => scene({}, 5).world.restoreSnapshot(world.saveSnapshot()), refused('SNAPSHOT_MISMATCH'));
  world.dispose();
  other.dispose();
});

test('100,000 bodies, views and transforms without copies', () => {
  const count = 100000;
  const { world, batch } = storm(lr, LR, leaf, count);
  const transforms = batch.createTransforms();
  for (let i = 0; i < 5; ++i) world.step(1 / 60);
  const matrices = transforms.write();
  const view = batch.view();
  assert.equal(matrices.length, 16 * count);
  assert.equal(matrices.buffer, lr.memory.buffer);
  assert.equal(view.position[0].buffer, lr.memory.buffer);
  for (const i of [0, 777, count - 1])
    assert.deepEqual([...matrices.subarray(16 * i + 12, 16 * i + 15)], view.position.map((p) => p[i]));
  const x = view.position[0][5];
  world.step(1 / 60);
  assert.notEqual(view.position[0][5], x, 'the view shows the present state');
  world.setSleep(view.ids.subarray(0, count - 10).slice(), true);
  assert.equal(transforms.writeMoved().length, 16 * count, 'places have changed');
  world.step(1 / 60);
  assert.equal(transforms.writeMoved().length, 16 * 10);
  transforms.dispose();
  assert.throws(() => transforms.write(), /disposed/);
  world.dispose();
});

test('the memory grows: buffers follow, old views are empty, nothing is lost', async () => {
  const small = await load();
  const { world, batch } = storm(small, LR, small.loadAsset(leafBytes), 1000);
  const transforms = batch.createTransforms(LR.TRANSFORM_3X4_ROW_MAJOR);
  const old = { buffer: small.memory.buffer, view: batch.view(), array: transforms.write() };
  const first = [...old.array.subarray(0, 12)];
  const other = world.createBatch({ asset: small.createEllipsoid({ semiAxes: [0.02, 0.02, 0.0005], density: 300 }), capacity: 2e5 });
  assert.notEqual(small.memory.buffer, old.buffer);
  assert.equal(old.view.position[0].length, 0);
  assert.equal(old.array.length, 0);
  assert.deepEqual([...transforms.array.subarray(0, 12)], first);
  assert.deepEqual([...transforms.write().subarray(0, 12)], first);
  other.createBodies({ count: 2e5 });
  world.step(1 / 60);
  assert.equal(other.view().count, 2e5);
});

test('out of memory is a status, and the world is unchanged', async () => {
  const { world, batch } = scene();
  batch.createBody();
  const before = world.hash();
  assert.throws(() => world.createBatch({ asset: leaf, capacity: 2 ** 26 }), refused('OUT_OF_MEMORY'));
  // By way of std::vector, which cannot throw here: a heap filled beforehand.
  const full = await load();
  const asset = full.loadAsset(leafBytes);
  const small = full.createWorld();
  const filled = [];
  for (let size = 1 << 28; size >= 16; size >>= 1) for (let at; (at = full.raw.malloc(size)) !== 0;) filled.push(at);
  assert.throws(() => full.createEllipsoid({ semiAxes: [1, 1, 1], density: 1 }), refused('OUT_OF_MEMORY'));
  assert.throws(() => small.createBatch({ asset, capacity: 1000 }), refused('OUT_OF_MEMORY'));
  for (const at of filled) full.raw.free(at);
  const stack = full.raw.__stack_pointer.value;
  small.createBatch({ asset, capacity: 1000 }).createBodies({ count: 1000 });
  small.step(1 / 60);
  assert.equal(full.raw.__stack_pointer.value, stack);
  assert.equal(world.hash(), before);
  world.step(1 / 60);
});

test('a defect ends the module with a message', async () => {
  const broken = await load();
  const world = broken.createWorld();
  world.createBatch({ asset: broken.loadAsset(leafBytes), capacity: 10 }).createBody();
  new Uint32Array(broken.memory.buffer, world.address, 4096).fill(0x7ffffff0); // addresses beyond the end of memory
  assert.throws(() => world.hash(), refused('INTERNAL'));
  assert.throws(() => broken.createWorld(), /stopped in lr_world_hash/);
});

test('forgotten objects are collected', async () => {
  const own = await load();
  const asset = own.loadAsset(leafBytes);
  for (let i = 0; i < 300; ++i) { // some GB in total
    const world = own.createWorld();
    world.createBatch({ asset, capacity: 50000 }).createTransforms();
    if (i % 10 === 9) {
      globalThis.gc();
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
  }
  assert.ok(own.memory.buffer.byteLength < 3e8, String(own.memory.buffer.byteLength));
  for (const [Class, made] of [[Asset, asset], [World, own.createWorld()]]) assert.ok(made instanceof Class);
  assert.ok(Batch && TransformBuffer);
});

test('a stopped recording releases its callback', async () => {
  const world = lr.createWorld();
  let wrote = 0;
  const file = (() => {
    const pieces = [];
    world.startRecording((bytes) => pieces.push(bytes) && (wrote += bytes.length));
    return new WeakRef(pieces);
  })();
  world.step(1 / 60);
  world.stopRecording();
  assert.ok(wrote > 100);
  for (let i = 0; i < 50 && file.deref(); ++i) {
    await new Promise((resolve) => setTimeout(resolve, 2));
    globalThis.gc();
  }
  assert.equal(file.deref(), undefined);
  world.step(1 / 60);
  world.dispose();
});

test('a module is loaded from an address, bytes, or compiled', async () => {
  const url = new URL(`${pathToFileURL(process.env.LR_PACKAGE)}/langevin_rigid.wasm`);
  const bytes = await readFile(url);
  for (const wasm of [url, url.href, bytes, new Uint8Array(bytes).buffer, await WebAssembly.compile(bytes)])
    assert.equal((await load({ wasm })).version, lr.version);
  await assert.rejects(load({ wasm: new Uint8Array([1, 2, 3, 4]) }), WebAssembly.CompileError);
});

test('its log reaches the caller', () => {
  const said = [];
  const world = lr.createWorld({ log: (level, message) => said.push([level, message]) });
  assert.throws(() => world.step(NaN), refused('TIMESTEP_NOT_FINITE'));
  assert.ok(said.some(([level]) => level === LR.LOG_ERROR), JSON.stringify(said));
  world.dispose();
});
