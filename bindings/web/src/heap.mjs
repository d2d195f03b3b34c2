// SPDX-License-Identifier: MIT
// The module's memory: views that follow its growth, and structs at the C compiler's offsets.
import { structs } from './generated/api.mjs';

const scalars = {
  f32: { size: 4, get: 'getFloat32', set: 'setFloat32' },
  f64: { size: 8, get: 'getFloat64', set: 'setFloat64' },
  u32: { size: 4, get: 'getUint32', set: 'setUint32' },
  i32: { size: 4, get: 'getInt32', set: 'setInt32' },
  u64: { size: 8, get: 'getBigUint64', set: 'setBigUint64' },
  big: { size: 8, get: 'getBigUint64', set: 'setBigUint64' },
  pointer: { size: 4, get: 'getUint32', set: 'setUint32' },
};
const utf8 = new TextDecoder();
const maxWord = (1n << 64n) - 1n;

const sizeOf = (type) => scalars[type]?.size ?? structs[type].size;
const singular = (name) => name.slice(0, -1);

export class Heap {
  #exports;
  #view;

  constructor(exports) {
    this.#exports = exports;
    this.#view = new DataView(exports.memory.buffer);
  }

  /** Changes when the memory grows: views of the old buffer are then empty. */
  get buffer() {
    return this.#exports.memory.buffer;
  }

  get view() {
    if (this.#view.buffer !== this.buffer) this.#view = new DataView(this.buffer);
    return this.#view;
  }

  array(Type, address, length) {
    return new Type(this.buffer, address, length);
  }

  allocate(bytes) {
    return this.#exports.malloc(Math.max(bytes, 1));
  }

  free(address) {
    this.#exports.free(address);
  }

  string(address) {
    if (address === 0) return '';
    const bytes = new Uint8Array(this.buffer, address);
    return utf8.decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  number(type, address) {
    const value = this.view[scalars[type].get](address, true);
    return type === 'u64' ? Number(value) : value;
  }

  #read(type, address) {
    return scalars[type] ? this.number(type, address) : this.read(type, address);
  }

  /** Reads a struct as an object. Pointers are addresses. */
  read(name, address) {
    const out = {};
    for (const [field, offset, type, count] of structs[name].fields) {
      const at = address + offset;
      if (type === 'char') out[field] = this.string(at);
      else if (count === 0) out[field] = this.#read(type, at);
      else {
        const used = scalars[type] ? count : out[`${singular(field)}Count`] ?? count;
        out[field] = Array.from({ length: used }, (_, i) => this.#read(type, at + i * sizeOf(type)));
      }
    }
    return out;
  }

  #writeScalar(type, address, value, field) {
    if (type === 'u64' || type === 'big') {
      this.view.setBigUint64(address, wholeWord(value, field), true);
      return;
    }
    if (typeof value !== 'number') throw new TypeError(`${field} must be a number, not ${value === null ? 'null' : typeof value}`);
    if (type === 'i32') whole(value, field, -(2 ** 31));
    else if (type[0] !== 'f') whole(value, field);
    this.view[scalars[type].set](address, value, true);
  }

  #write(type, address, value, field) {
    if (scalars[type]) this.#writeScalar(type, address, value, field);
    else this.write(type, address, value, field);
  }

  /** Writes the fields of an object; other fields of the struct stay. */
  write(name, address, values, where = name) {
    if (values === null || typeof values !== 'object') throw new TypeError(`${where} must be an object, not ${values}`);
    const { fields } = structs[name];
    for (const key of Object.keys(values)) {
      const row = fields.find(([field]) => field === key);
      if (!row) throw new TypeError(`${where} has no field ${key}; it has ${fields.map(([field]) => field).join(', ')}`);
      const [, offset, type, count] = row;
      const value = values[key];
      const field = `${where}.${key}`;
      if (value === undefined) continue;
      if (count === 0) {
        this.#write(type, address + offset, value, field);
        continue;
      }
      const given = value?.length;
      if (scalars[type] ? given !== count : !(given <= count))
        throw new RangeError(`${field} must have ${scalars[type] ? '' : 'up to '}${count} elements, not ${given}`);
      for (let i = 0; i < given; ++i) this.#write(type, address + offset + i * sizeOf(type), value[i], `${field}[${i}]`);
      const total = fields.find(([other]) => other === `${singular(key)}Count`);
      if (!scalars[type] && total && values[total[0]] === undefined) this.#writeScalar('u32', address + total[1], given, total[0]);
    }
  }
}

/** Memory for the arguments of a call, freed together. */
export class Scratch {
  #heap;
  #init;
  #taken = [];

  /** @param init (function's name, address, size): makes the library fill a struct with its initial values */
  constructor(heap, init, outOfMemory) {
    this.#heap = heap;
    this.#init = init;
    this.outOfMemory = outOfMemory;
  }

  bytes(size) {
    const address = this.#heap.allocate(size);
    if (address === 0) throw this.outOfMemory();
    this.#taken.push(address);
    return address;
  }

  /** An initialised struct with these values; zeroed without an init function. */
  struct(name, values = {}) {
    return this.structs(name, [values]);
  }

  structs(name, all) {
    const { size, init } = structs[name];
    const address = this.bytes(size * all.length);
    this.#heap.array(Uint8Array, address, size * all.length).fill(0);
    all.forEach((values, i) => {
      const at = address + i * size;
      if (init) this.#init(init, at, size);
      this.#heap.write(name, at, values, all.length > 1 ? `${name}[${i}]` : name);
    });
    return address;
  }

  /** The address of a copy of an array; 0 for null. */
  copy(Type, values) {
    if (values === null || values === undefined) return 0;
    const address = this.bytes(values.length * Type.BYTES_PER_ELEMENT);
    this.#heap.array(Type, address, values.length).set(values);
    return address;
  }

  text(string) {
    return this.copy(Uint8Array, new TextEncoder().encode(`${string}\0`));
  }

  release() {
    while (this.#taken.length) this.#heap.free(this.#taken.pop());
  }
}

/** The argument `name`, of 32 bits from `low`: WebAssembly would make other numbers of fractions, signs and strings. */
export function whole(value, name, low = 0) {
  const past = low + 2 ** 32;
  if (!Number.isInteger(value) || value < low || value >= past) throw new RangeError(`${name} must be a whole number from ${low} to ${past - 1}, not ${value}`);
  return value;
}

/** The same of 64 bits, given as a number or a bigint. */
export function wholeWord(value, name) {
  const word = typeof value === 'bigint' ? value : Number.isSafeInteger(value) ? BigInt(value) : -1n;
  if (word < 0n || word > maxWord) throw new RangeError(`${name} must be a whole number from 0 to 2^64 - 1, not ${value}`);
  return word;
}

/** The argument `name`, an array of objects. */
export function list(values, name) {
  if (!Array.isArray(values)) throw new TypeError(`${name} must be an array, not ${values === null ? 'null' : typeof values}`);
  return values;
}

/** The argument `name`, a vector. */
export function three(values, name) {
  if (values?.length !== 3) throw new RangeError(`${name} must have 3 elements, not ${values?.length}`);
  return values;
}
