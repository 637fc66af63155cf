// Reads PNG as Pomona and browsers write it: 8 bits, without interlacing.
import {inflateSync} from 'node:zlib';

const most = 4096 * 4096;  // texels

const paeth = (a, b, c) => {
  const p = a + b - c, da = Math.abs(p - a), db = Math.abs(p - b), dc = Math.abs(p - c);
  return da <= db && da <= dc ? a : db <= dc ? b : c;
};
const predictions = [() => 0, (a) => a, (a, b) => b, (a, b) => a + b >> 1, paeth];

/** Rows without their filters, in place of those with. */
function unfiltered(packed, width, height, channels) {
  const stride = width * channels, rows = new Uint8Array(stride * height);
  if (packed.length !== (stride + 1) * height) throw new Error('a PNG of another size than it says');
  for (let y = 0; y < height; ++y) {
    const predict = predictions[packed[y * (stride + 1)]];
    if (!predict) throw new Error('a PNG with a filter that there is not');
    for (let x = 0; x < stride; ++x) {
      const at = y * stride + x, left = x >= channels;
      const a = left ? rows[at - 1 * channels] : 0, b = y ? rows[at - stride] : 0;
      rows[at] = packed[y * (stride + 1) + 1 + x] + predict(a, b, left && y ? rows[at - stride - channels] : 0);
    }
  }
  return rows;
}

/** The picture as {width, height, data}, four bytes a texel. Throws Error for what is none. */
export function readPng(bytes) {
  const file = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (file.length < 33 || file.readUInt32BE(0) !== 0x89504e47) throw new Error('no PNG');
  const [width, height] = [file.readUInt32BE(16), file.readUInt32BE(20)];
  const channels = {0: 1, 2: 3, 4: 2, 6: 4}[file[25]];
  if (file[24] !== 8 || !channels || file[28]) throw new Error('a PNG that is not of 8 bits, or interlaced');
  if (!width || !height || width * height > most) throw new Error(`a PNG of ${width} x ${height} texels`);
  const parts = [];
  for (let at = 8; at + 12 <= file.length;) {
    const length = file.readUInt32BE(at), name = file.toString('latin1', at + 4, at + 8);
    if (name === 'IDAT') parts.push(file.subarray(at + 8, at + 8 + length));
    if (name === 'IEND') break;
    at += 12 + length;
  }
  const packed = inflateSync(Buffer.concat(parts), {maxOutputLength: (width * channels + 1) * height});
  const rows = unfiltered(packed, width, height, channels), data = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; ++i) {
    const gray = channels < 3;
    for (let k = 0; k < 3; ++k) data[4 * i + k] = rows[channels * i + (gray ? 0 : k)];
    data[4 * i + 3] = channels % 2 ? 255 : rows[channels * i + channels - 1];
  }
  return {width, height, data};
}
