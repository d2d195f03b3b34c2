// SPDX-License-Identifier: MIT
// 2000 leaves in gusts of wind, drawn by three.js: one InstancedMesh whose matrices the library writes.
import { load, LR } from 'langevin-rigid';
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const count = 2000;
const lr = await load();
// A leaf of 7 x 4 cm and 0.2 g as an ellipsoid. For your own mesh: lr_bake, then await lr.fetchAsset('leaf.lrb').
const leaf = lr.createEllipsoid({ semiAxes: [0.035, 0.02, 0.00015], density: 350 });
const world = lr.createWorld({ seed: 1 });
const batch = world.createBatch({ asset: leaf, capacity: count });
world.createCollider({ kind: LR.COLLIDER_PLANE });
world.setUniformWind([1, 0, 0.3]);
world.addGusts({ rms: 0.8 });
world.addTurbulence({ rms: 0.4, integralLength: 1 });
// The air is full of leaves at once; after 12 s each falls again.
batch.spawnBox([-6, 0.1, -5], [4, 4, 4], count);
batch.setEmitter({ shape: LR.EMIT_BOX, position: [-2, 3.5, -0.5], size: [5, 1, 4.5] });
batch.setRules({ action: LR.END_RESPAWN, maxAge: 12 });
const transforms = batch.createTransforms(LR.TRANSFORM_4X4_COLUMN_MAJOR); // as three.js has them

const scene = new THREE.Scene();
scene.background = new THREE.Color(0xb9cbd6);
scene.fog = new THREE.Fog(0xb9cbd6, 6, 20);
const sun = new THREE.DirectionalLight(0xfff0d8, 3);
sun.position.set(3, 6, 2);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
scene.add(sun, new THREE.HemisphereLight(0xcfe4ff, 0x6b5a3a, 1.2));
const lawn = new THREE.Mesh(new THREE.PlaneGeometry(60, 60).rotateX(-Math.PI / 2), new THREE.MeshStandardMaterial({ color: 0x6f7f45 }));
lawn.receiveShadow = true;
scene.add(lawn);

// The outline of a leaf in the plane of the ellipsoid's long axes, a little bent.
const outline = new THREE.Shape().moveTo(-0.035, 0).quadraticCurveTo(0, 0.032, 0.035, 0).quadraticCurveTo(0, -0.032, -0.035, 0);
const blade = new THREE.ShapeGeometry(outline, 8);
const places = blade.attributes.position;
for (let i = 0; i < places.count; ++i) places.setZ(i, 3 * places.getY(i) ** 2);
blade.computeVertexNormals();
const leaves = new THREE.InstancedMesh(blade, new THREE.MeshStandardMaterial({ side: THREE.DoubleSide, roughness: 0.8 }), count);
for (let i = 0; i < count; ++i) leaves.setColorAt(i, new THREE.Color().setHSL(0.04 + 0.1 * Math.random(), 0.85, 0.3 + 0.25 * Math.random()));
leaves.castShadow = true;
leaves.frustumCulled = false; // its box does not know where the instances are
scene.add(leaves);

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.shadowMap.enabled = true;
document.body.append(renderer.domElement);
const camera = new THREE.PerspectiveCamera(50, 1, 0.05, 100);
camera.position.set(1.2, 1.1, 3.4);
const controls = new OrbitControls(camera, renderer.domElement);
controls.target.set(0, 0.8, 0);

function resize() {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  renderer.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

let late = 0;
const clock = new THREE.Clock();
renderer.setAnimationLoop(() => {
  // Fixed steps: the same leaves at any frame rate. After a pause of the page, time goes on from there.
  late = Math.min(late + clock.getDelta(), 0.1);
  for (; late >= 1 / 60; late -= 1 / 60) world.step(1 / 60, 2);
  leaves.instanceMatrix.array.set(transforms.write());
  leaves.instanceMatrix.needsUpdate = true;
  controls.update();
  renderer.render(scene, camera);
});
globalThis.leaves = { world, batch }; // for the browser's console
