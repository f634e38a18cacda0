// SPDX-License-Identifier: Apache-2.0
// Structs of C as objects, and back: functions that are made from the layout. They take a hundredth of the time of
// koffi.decode, which looks at the type of each field each time.
import koffi from 'koffi';
import { expectStruct, refusal } from './given.mjs';

const arrays = { Float64: ['f64', 3], UInt32: ['u32', 2], UInt64: ['u64', 3] };

function indexOf(type, offset) {
  const [array, shift] = arrays[type.primitive];
  return `${array}[at + ${offset} >>> ${shift}]`;
}

function fieldsOf(type) {
  return Object.values(type.members).filter((field) => field.name !== 'reserved');
}

function readText(type, offset) {
  if (!type.members) return indexOf(type, offset);
  return `{ ${fieldsOf(type).map((field) => `${field.name}: ${readText(field.type, offset + field.offset)}`).join(', ')} }`;
}

function writeText(type, offset, value) {
  if (type.members) {
    return fieldsOf(type).map((field) => writeText(field.type, offset + field.offset, `${value}.${field.name}`)).join('\n');
  }
  // Whole numbers that do not fit are told apart by what is read back.
  const place = indexOf(type, offset);
  return type.primitive === 'UInt32' ? `if ((${place} = ${value}) !== ${place}) throw new TypeError();` : `${place} = ${value};`;
}

/** Memory for structs of one type, which goes to a call as its `bytes`. */
class Memory {
  constructor(codec, buffer) {
    this.codec = codec;
    this.buffer = buffer;
    this.bytes = new Uint8Array(buffer);
    this.f64 = new Float64Array(buffer, 0, buffer.byteLength >>> 3);
    this.u32 = new Uint32Array(buffer, 0, buffer.byteLength >>> 2);
    this.u64 = new BigUint64Array(buffer, 0, buffer.byteLength >>> 3);
  }

  get(index = 0) {
    return this.codec.read(this.f64, this.u32, this.u64, index * this.codec.size);
  }

  set(value, index = 0, name = 'value') {
    try {
      this.codec.write(this.f64, this.u32, this.u64, index * this.codec.size, value);
    } catch (thrown) {
      expectStruct(name, this.codec.struct, value);
      throw thrown;
    }
  }

  first(count) {
    return Array.from({ length: count }, (_, index) => this.get(index));
  }
}

/** How one type of struct lies in memory. */
export class Codec {
  constructor(struct) {
    this.struct = struct;
    this.size = koffi.sizeof(struct);
    this.read = new Function('f64', 'u32', 'u64', 'at', `return ${readText(struct, 0)};`);
    this.write = new Function('f64', 'u32', 'u64', 'at', 'value', writeText(struct, 0, 'value'));
  }

  /** Memory for so many. */
  room(count = 1) {
    return new Memory(this, new ArrayBuffer(Math.max(this.size * count, 8)));
  }

  /** Objects in new memory. */
  encode(values, name = 'values') {
    if (typeof values?.length !== 'number') refusal.throws(`${name} is ${values}; expected an array`);
    const memory = this.room(values.length);
    for (let i = 0; i < values.length; ++i) memory.set(values[i], i, `${name}[${i}]`);
    return memory.bytes;
  }

  /** Copies of structs in memory that the library lends. */
  copies(pointer, count) {
    return count === 0 ? [] : new Memory(this, koffi.view(pointer, this.size * count)).first(count);
  }

  /** Objects that a call fills by count-then-fill, with room for as many at first: call(place, capacity, count). */
  fill(call, room = 8) {
    const count = [0];
    for (let capacity = room; ; capacity = Number(count[0])) {
      const place = this.room(capacity);
      call(place.bytes, capacity, count);
      if (Number(count[0]) <= capacity) return place.first(Number(count[0]));
    }
  }
}
