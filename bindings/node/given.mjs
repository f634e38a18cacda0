// SPDX-License-Identifier: Apache-2.0
// What a caller has given, before it goes to C: whole numbers would be cut there, and a failure would not have their names.

/** How a wrong value is refused; library.mjs sets it. */
export const refusal = { throws(text) { throw new TypeError(text); } };

const shown = (value) => (typeof value === 'string' ? JSON.stringify(value) : String(value));

export function expectNumber(name, value) {
  if (typeof value !== 'number') refusal.throws(`${name} is ${shown(value)}; expected a number`);
}

/** A whole number of 32 or 64 bits that is not negative; of 64 bits it may be a bigint. */
export function expectWhole(name, value, bits) {
  const fits = typeof value === 'bigint' ? bits === 64 && BigInt.asUintN(64, value) === value
    : bits === 32 ? value >>> 0 === value : Number.isSafeInteger(value) && value >= 0;
  if (!fits) {
    refusal.throws(`${name} is ${shown(value)}; expected a whole number from 0 to ${bits === 32 ? 2 ** 32 - 1 : '2^53 - 1, or a bigint below 2^64'}`);
  }
}

/** Refuses a value that is not an object with the members of a struct, by the name of the first that is wrong. The library
 * itself names numbers that are missing, where they get to it as NaN; `strict` names them here. */
export function expectStruct(name, type, value, strict = false) {
  if (value === null || typeof value !== 'object') {
    const members = Object.keys(type.members).filter((member) => member !== 'reserved').join(', ');
    refusal.throws(`${name} is ${shown(value)}; expected an object with ${members}`);
  }
  for (const [member, { type: its }] of Object.entries(type.members)) {
    if (member === 'reserved') continue;
    if (its.members) expectStruct(`${name}.${member}`, its, value[member], strict);
    else if (its.primitive === 'UInt32') expectWhole(`${name}.${member}`, value[member], 32);
    else if (its.primitive === 'UInt64') expectWhole(`${name}.${member}`, value[member], 64);
    else if (strict) expectNumber(`${name}.${member}`, value[member]);
  }
}
