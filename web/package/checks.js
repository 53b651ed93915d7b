// Checks of input: known options, arrays of the right type and length.
import { BrindleError } from './error.js';

export const fail = (message) => {
  throw new BrindleError(message);
};

// The given options. Defaults determine the types.
export function options(given, known, what) {
  const result = { ...known };
  for (const [name, value] of Object.entries(given ?? {})) {
    if (!(name in known)) {
      fail(`${what} knows no option '${name}'; it knows ${Object.keys(known).join(', ')}`);
    }
    if (value === undefined) continue;
    if (typeof known[name] === 'number' && !(typeof value === 'number' && Number.isFinite(value))) {
      fail(`${what}: '${name}' must be a finite number, not ${String(value)}`);
    }
    if (typeof known[name] === 'boolean' && typeof value !== 'boolean') {
      fail(`${what}: '${name}' must be true or false`);
    }
    result[name] = value;
  }
  return result;
}

export function choice(value, names, what) {
  return names.includes(value) ? value : fail(`${what} must be ${names.join(' or ')}, not '${value}'`);
}

// Such options with a crease angle, with the error message of the library's option table, which would
// add 12 kB to either module.
export function creased(o) {
  if (!(o.creaseAngle >= 0 && o.creaseAngle <= 180)) fail(`creaseAngle: expected a number from 0 to 180, got '${o.creaseAngle}'`);
  return o;
}

const tables = [Float32Array, Float64Array, Int32Array, Uint32Array];

// Converts numbers to an array type of the module; not 64-bit integers.
export function table(numbers, what) {
  if (tables.some((type) => numbers instanceof type)) return numbers;
  if (numbers instanceof Uint16Array || numbers instanceof Uint8Array) return Uint32Array.from(numbers);
  if (numbers instanceof Int16Array || numbers instanceof Int8Array) return Int32Array.from(numbers);
  if (Array.isArray(numbers) && numbers.every((n) => typeof n === 'number')) {
    return Float64Array.from(numbers);
  }
  return fail(`${what} must be a typed array or an array of numbers`);
}

// The same for vertex numbers: plain arrays become integers if possible.
export function corners(numbers) {
  const whole = Array.isArray(numbers) && numbers.every((n) => Number.isInteger(n) && Math.abs(n) < 2 ** 31);
  return whole ? Int32Array.from(numbers) : table(numbers, 'triangles');
}

export function floats(numbers, count, what) {
  const array = numbers instanceof Float32Array ? numbers : Float32Array.from(table(numbers, what));
  if (array.length !== count) fail(`${what} must have ${count} numbers, not ${array.length}`);
  return array;
}

// The array to fill: the given one, or a new one if requested.
export function filled(wanted, count, what) {
  if (wanted === undefined || wanted === false) return undefined;
  if (wanted === true) return new Float32Array(count);
  if (!(wanted instanceof Float32Array) || wanted.length !== count) {
    fail(`${what} must be true or a Float32Array of ${count} numbers`);
  }
  return wanted;
}
