// SPDX-License-Identifier: MIT
// The page: controls, frame loop, and the camera's mouse control.
import { load } from './package/langevin_rigid.mjs';
import { models } from './models.mjs';
import { Renderer } from './render.mjs';
import { assetOf, Storm } from './storm.mjs';

const element = (id) => document.getElementById(id);
const given = new URLSearchParams(location.search);
const settings = {
  model: models[given.get('model')] ? given.get('model') : 'leaf', count: Number(given.get('count')) || 5000, wind: Number(given.get('wind') ?? 1.5),
  gusts: Number(given.get('gusts') ?? 1), direction: Number(given.get('direction') ?? 20),
};
const camera = { yaw: 0.5, pitch: 0.16, distance: 1.7 };
const dt = 1 / 60;
const state = { frames: 0, steps: 0, paused: given.has('paused'), stepMs: 0, fps: 0, settings, camera, storm: null };
globalThis.leafStorm = state; // for tests and for the browser's console

function problem(error) {
  element('problem').textContent = error.message ?? String(error);
  element('problem').hidden = false;
  console.error(error);
}

async function run() {
  const lr = await load();
  const renderer = new Renderer(element('canvas'));
  const assets = new Map();
  let making = 0;

  async function restart() {
    const turn = ++making;
    const model = models[settings.model];
    if (!assets.has(settings.model)) assets.set(settings.model, await assetOf(lr, model));
    if (turn !== making) return; // the user has made another choice meanwhile
    state.storm?.dispose();
    state.storm = new Storm(lr, assets.get(settings.model), model, settings.count);
    state.storm.setWind(settings);
    renderer.setModel(model, settings.count);
    state.steps = 0;
  }

  function show() {
    element('count-value').value = settings.count.toLocaleString('en');
    element('wind-value').value = `${settings.wind.toFixed(1)} m/s`;
    element('gusts-value').value = `${settings.gusts.toFixed(1)} m/s`;
    element('direction-value').value = `${settings.direction}°`;
    element('pause').textContent = state.paused ? 'Go on' : 'Pause';
  }

  function control() {
    element('panel').open = !matchMedia('(max-width: 600px), (max-height: 420px)').matches; // a phone has little room
    for (const [key, { name }] of Object.entries(models)) element('model').add(new Option(name, key, false, key === settings.model));
    element('count').value = Math.log10(settings.count);
    for (const id of ['wind', 'gusts', 'direction']) {
      element(id).value = settings[id];
      element(id).addEventListener('input', () => {
        settings[id] = Number(element(id).value);
        state.storm?.setWind(settings);
        show();
      });
    }
    element('count').addEventListener('input', () => {
      settings.count = Math.round(10 ** element('count').value);
      show();
    });
    element('count').addEventListener('change', () => restart().catch(problem));
    element('model').addEventListener('change', () => {
      settings.model = element('model').value;
      restart().catch(problem);
    });
    element('restart').addEventListener('click', () => restart().catch(problem));
    element('pause').addEventListener('click', () => {
      state.paused = !state.paused;
      show();
    });
    element('step').addEventListener('click', () => {
      state.paused = true;
      step();
      show();
    });
    orbit(element('canvas'));
    show();
  }

  function step() {
    const before = performance.now();
    state.storm.step(dt);
    const took = performance.now() - before;
    state.stepMs = state.stepMs === 0 ? took : 0.95 * state.stepMs + 0.05 * took;
    ++state.steps;
  }

  let last = performance.now();
  let owed = 0;
  let since = last;
  let drawn = 0;
  function frame(now) {
    try {
      if (state.storm) {
        // Takes as many steps as time has passed, but at most two: a slow machine falls behind.
        owed = Math.min(owed + (now - last) / 1000, 2 * dt);
        if (state.paused) owed = 0;
        for (; owed >= dt; owed -= dt) step();
        renderer.draw(state.storm, camera);
        ++state.frames;
        ++drawn;
        if (now - since > 500) {
          state.fps = (1000 * drawn) / (now - since);
          const { awakeCount, count } = state.storm.batch.view();
          element('stats').textContent = `${state.fps.toFixed(0)} fps, ${state.stepMs.toFixed(2)} ms a step\n` +
            `${awakeCount.toLocaleString('en')} of ${count.toLocaleString('en')} in the air\n` +
            `${lr.simdTargetName(state.storm.world.info.simdTarget)} SIMD, ${(lr.memory.buffer.byteLength / 2 ** 20).toFixed(0)} MiB`;
          drawn = 0;
          since = now;
        }
      }
      last = now;
      requestAnimationFrame(frame);
    } catch (error) {
      problem(error);
    }
  }

  control();
  await restart();
  requestAnimationFrame(frame);
}

function orbit(canvas) {
  let x = 0;
  let y = 0;
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    [x, y] = [event.clientX, event.clientY];
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    camera.yaw -= 0.005 * (event.clientX - x);
    camera.pitch = Math.min(1.5, Math.max(0.02, camera.pitch + 0.005 * (event.clientY - y)));
    [x, y] = [event.clientX, event.clientY];
  });
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    camera.distance = Math.min(6, Math.max(0.3, camera.distance * Math.exp(0.001 * event.deltaY)));
  }, { passive: false });
}

run().catch(problem);
