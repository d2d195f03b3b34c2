// SPDX-License-Identifier: MIT
// The page in a real browser: node page.mjs chromium SITE DIRECTORY (for screenshots)
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { pathToFileURL } from 'node:url';

import { Browser, pixels, serve } from './browser.mjs';

const [, , program, site, directory] = process.argv;
const server = await serve(site);
const browser = await Browser.open(program, { width: 560, height: 360 });
const storm = (what) => browser.evaluate(`leafStorm.${what}`);
const later = (steps) => storm('steps').then((now) => browser.until(`leafStorm.steps >= ${now} + ${steps}`, 60));
const slide = (id, value, event = 'input') => browser.evaluate(
  `{ const e = document.getElementById('${id}'); e.value = ${JSON.stringify(value)}; e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('${event}')); }`);
const click = (id) => browser.evaluate(`document.getElementById('${id}').click()`);
const count = () => storm('storm.batch.view().count');
const mean = (axis) => browser.evaluate(
  `(() => { const b = leafStorm.storm.batch.view(), p = b.position[${axis}]; return p.slice(0, b.awakeCount).reduce((a, x) => a + x, 0) / b.awakeCount; })()`);

async function picture(name) {
  const png = await browser.screenshot();
  await writeFile(join(directory, name), png);
  return pixels(png);
}
/** The share of pixels outside the panel that differ by more than a little. */
function difference(a, b) {
  let differ = 0;
  let all = 0;
  for (let y = 0; y < a.height; ++y)
    for (let x = 260; x < a.width; ++x, ++all) {
      const at = (y * a.width + x) * a.channels;
      if (Math.abs(a.data[at] - b.data[at]) + Math.abs(a.data[at + 1] - b.data[at + 1]) + Math.abs(a.data[at + 2] - b.data[at + 2]) > 30) ++differ;
    }
  return differ / all;
}

try {
  await browser.send('Page.navigate', { url: `${server.url}?count=1000` });
  await browser.until('globalThis.leafStorm?.frames > 3', 60);
  assert.equal(await count(), 1000);
  await later(30);
  assert.equal(await browser.evaluate("document.getElementById('panel').open"), false, 'on a narrow screen the panel is folded');
  await browser.evaluate("document.querySelector('#panel summary').click()");
  assert.ok(await browser.evaluate("document.getElementById('panel').getBoundingClientRect().bottom <= innerHeight"), 'all of it can be scrolled to');
  await browser.until("document.getElementById('stats').textContent.includes('fps')");
  assert.match(await browser.evaluate("document.getElementById('stats').textContent"), /ms a step\n.*of 1,000 in the air\nWebAssembly SIMD/);

  // It runs, pauses, and takes a single step.
  const first = await picture('leaf.png');
  await later(20);
  const second = await picture('leaf_later.png');
  assert.ok(difference(first, second) > 0.005, `leaves move: ${difference(first, second)}`);
  await click('pause');
  await later(0);
  await browser.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
  const steps = await storm('steps');
  const still = await picture('paused.png');
  assert.equal(difference(still, await picture('paused.png')), 0);
  assert.equal(await storm('steps'), steps);
  await click('step');
  assert.equal(await storm('steps'), steps + 1);

  // The mouse turns the view, the wheel moves it nearer.
  const [yaw, distance] = [await storm('camera.yaw'), await storm('camera.distance')];
  const mouse = (type, x, more = {}) => browser.send('Input.dispatchMouseEvent', { type, x, y: 200, button: 'left', clickCount: 1, ...more });
  await mouse('mousePressed', 400, { buttons: 1 });
  await mouse('mouseMoved', 500, { buttons: 1 });
  await mouse('mouseReleased', 500);
  await browser.until(`leafStorm.camera.yaw !== ${yaw}`);
  await browser.send('Input.dispatchMouseEvent', { type: 'mouseWheel', x: 400, y: 200, deltaX: 0, deltaY: -300 });
  await browser.until(`leafStorm.camera.distance < ${distance}`);
  await browser.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
  assert.ok(difference(still, await picture('turned.png')) > 0.05, 'the view has turned');
  await click('pause');

  // Wind carries bodies, in either direction.
  await slide('gusts', 0);
  await slide('direction', 0);
  await slide('wind', 0);
  await later(20);
  const speed = () => browser.evaluate(`leafStorm.storm.world.sampleWind([0, leafStorm.storm.model.room[1], 0])`).then((w) => w[0]);
  assert.ok(Math.abs(await speed()) < 0.2);
  await slide('wind', 6);
  const before = await mean(0);
  await later(15);
  assert.ok(Math.abs((await speed()) - 6) < 0.1, String(await speed()));
  assert.ok((await mean(0)) > before + 0.1, 'they are blown along');
  await slide('direction', -180);
  await later(30);
  assert.ok((await speed()) < -5.9);

  // The chosen number and model.
  await slide('wind', 1.5);
  await slide('gusts', 1);
  await slide('count', 3.2, 'change');
  await browser.until('leafStorm.storm.batch.view().count === 1585');
  for (const model of ['petal', 'confetti', 'paper', 'curled', 'seed', 'maple']) {
    await slide('model', model, 'change');
    await browser.until(`leafStorm.storm.model.name === [...document.getElementById('model').options].find((o) => o.value === '${model}').text`);
    await later(20);
    assert.ok(difference(first, await picture(`${model}.png`)) > 0.01, model);
    assert.equal(await count(), 1585);
  }
  assert.deepEqual(browser.errors, []);
  console.log(`frames: ${await storm('frames')}, ${(await storm('stepMs')).toFixed(2)} ms a step of 1,585 bodies`);

  // Opened as a file it says what to do.
  await browser.send('Page.navigate', { url: pathToFileURL(join(resolve(site), 'index.html')).href });
  for (let i = 0; i < 100 && !(await browser.evaluate("document.getElementById('problem')?.textContent")); ++i) await sleep(100);
  assert.match(await browser.evaluate("document.getElementById('problem').innerText"), /http\.server/);
} catch (error) {
  console.error(`errors of the page: ${browser.errors.join('\n') || 'none'}`);
  throw error;
} finally {
  await browser.close();
  server.close();
}
