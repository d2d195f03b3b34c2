// node run_wasi.mjs program.wasm [arguments]: runs a WASI program with access to all files.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

process.removeAllListeners('warning'); // hides the warning that node's WASI is experimental
process.on('warning', (warning) => { if (warning.name !== 'ExperimentalWarning') console.error(warning); });

const [program, ...rest] = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', args: [program, ...rest], env: process.env, preopens: { '/': '/' } });
const module = await WebAssembly.compile(await readFile(program));
const instance = await WebAssembly.instantiate(module, wasi.getImportObject());
process.exitCode = wasi.start(instance);
