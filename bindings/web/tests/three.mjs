// SPDX-License-Identifier: MIT
// The npm package with three.js, built by Vite, in a real browser:    node three.mjs CHROMIUM PACKAGE DIRECTORY
// Needs a registry of npm packages; exit code 77 without one.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdir, rm, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';

import { Browser, pixels, serve } from './browser.mjs';

const [program, packed, directory] = [process.argv[2], ...process.argv.slice(3).map((path) => resolve(path))];
const work = join(directory, 'three');
await rm(work, { recursive: true, force: true });
await mkdir(work, { recursive: true });

function npm(...words) {
  const { status, stdout, stderr } = spawnSync('npm', words, { cwd: work, encoding: 'utf8' });
  return { good: status === 0, text: stdout + stderr };
}
const tarball = npm('pack', '--silent', packed);
assert.ok(tarball.good, tarball.text);
const file = tarball.text.trim().split('\n').at(-1);
assert.equal(spawnSync('tar', ['xf', file, '--strip-components=3', 'package/examples/three'], { cwd: work }).status, 0, 'the package has the example');
const installed = npm('install', '--no-audit', '--no-fund', join(work, file));
if (!installed.good) {
  console.log(`no packages from a registry:\n${installed.text}`);
  process.exit(/E(NOTFOUND|CONNREFUSED|AI_AGAIN|TIMEDOUT|NETUNREACH)|40[34]/.test(installed.text) ? 77 : 1);
}
const built = npm('run', 'build');
assert.ok(built.good, built.text);

const server = await serve(join(work, 'dist'));
const browser = await Browser.open(program, { width: 640, height: 400 });
try {
  await browser.send('Page.navigate', { url: server.url });
  await browser.until('globalThis.leaves?.world.info.time > 2', 120);
  const heights = await browser.evaluate('(() => { const v = leaves.batch.view(); return [...v.position[1].slice(0, v.count)]; })()');
  assert.equal(heights.length, 2000);
  assert.ok(heights.every((y) => y > -0.01 && y < 5), 'leaves are between the ground and the place of their births');
  const png = await browser.screenshot();
  await writeFile(join(directory, 'three.png'), png);
  const { data, channels } = pixels(png);
  const colours = new Set();
  for (let at = 0; at < data.length; at += channels) colours.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
  assert.ok(colours.size > 1000, `${colours.size} colours`);
  assert.deepEqual(browser.errors, []);
} finally {
  await browser.close();
  server.close();
}
console.log(`three.js: ${join(directory, 'three.png')}`);
