// The arrays of numbers that the page carries: PageData of page_data.h says how they are stored.

const types = {f64: Float64Array, i32: Int32Array, u16: Uint16Array, u8: Uint8Array};
const unpacked = new Map();

async function unpack(number) {
  const element = document.getElementById(`array-${number}`);
  const binary = atob(element.textContent);
  const packed = new Uint8Array(binary.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = binary.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const Type = types[element.dataset.type];
  const count = Number(element.dataset.count), size = Type.BYTES_PER_ELEMENT;
  const bytes = new Uint8Array(count * size);
  for (let b = 0; b < size; ++b)
    for (let i = 0, from = b * count, to = b; i < count; ++i, ++from, to += size) bytes[to] = planes[from];
  return new Type(bytes.buffer);
}

/// A promise of the array of that number.
export function arrayOf(number) {
  if (!unpacked.has(number)) unpacked.set(number, unpack(number));
  return unpacked.get(number);
}

const noLimit = 65534, none = 65535, top = 65533;  // as in mesh_pack.cpp

/// The numbers of a field of a frame; NaN where there is none.
export async function fieldValues(field) {
  const codes = await arrayOf(field.array);
  if (field.kind === 'class') return Float64Array.from(codes);
  const values = new Float64Array(codes.length);
  const logarithmic = field.kind === 'logarithmic';
  const low = logarithmic ? Math.log(field.min) : field.min;
  const range = (logarithmic ? Math.log(field.max) : field.max) - low;
  for (let i = 0; i < codes.length; ++i) {
    const code = codes[i];
    const value = low + range * code / top;
    values[i] = code === none ? NaN : code === noLimit ? Infinity : logarithmic ? Math.exp(value) : value;
  }
  return values;
}
