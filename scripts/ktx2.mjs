// Codes the pictures of a .glb as KTX2 (KHR_texture_basisu), which graphics cards keep as it is:
// docs/guides/engines.md.
//   node scripts/ktx2.mjs IN.glb OUT.glb
// They become UASTC, made to pack well, with all levels: ETC1S is smaller, and its colours err twice as much. Palettes,
// in which each texel is a look of its own, stay PNG. Same file, same bytes. Run where node_modules lies (npm ci).
// Status 0; 1 for a file that it cannot code, 2 for other words than these.
import {encodeToKTX2} from 'ktx2-encoder';
import {readFileSync, writeFileSync} from 'node:fs';

import {readPng} from './png.mjs';

const palette = 'looks';  // begins the names of their textures
const most = 12 << 20;    // texels: Basis Universal takes no more

/** The chunks of a .glb. */
function opened(bytes) {
  if (bytes.length < 28 || bytes.readUInt32LE(0) !== 0x46546c67 || bytes.readUInt32LE(8) !== bytes.length)
    throw new Error('no .glb');
  const length = bytes.readUInt32LE(12), binary = 20 + length;
  if (length > bytes.length - 28 || bytes.readUInt32LE(binary) > bytes.length - binary - 8)
    throw new Error('a .glb that ends too soon');
  return {
    json: JSON.parse(bytes.toString('utf8', 20, binary)),
    binary: bytes.subarray(binary + 8, binary + 8 + bytes.readUInt32LE(binary)),
  };
}

/** The textures that materials name, each with what for. */
function uses(json) {
  const found = new Map();
  const search = (value) => {
    for (const [name, inner] of Object.entries(value ?? {})) {
      if (typeof inner !== 'object') continue;
      if (name.endsWith('Texture') && Number.isInteger(inner?.index))
        found.set(inner.index, [...found.get(inner.index) ?? [], name]);
      else search(inner);
    }
  };
  search(json.materials);
  return found;
}

const isColor = (names) => names.some((name) => name === 'baseColorTexture' || name.endsWith('ColorTexture'));

async function coded(png, names) {
  const picture = readPng(png), color = isColor(names);
  if (picture.width % 4 || picture.height % 4)
    throw new Error(`a picture of ${picture.width} x ${picture.height}: sides have to be multiples of 4`);
  if (picture.width * picture.height > most) throw new Error('a picture of more than 12 million texels');
  return encodeToKTX2(png, {
    imageDecoder: async () => picture,
    isUASTC: true,
    enableRDO: true,
    rdoQualityLevel: 1,
    isPerceptual: color,
    isSetKTX2SRGBTransferFunc: color,
    isNormalMap: names.includes('normalTexture'),
    needSupercompression: true,
    generateMipmap: true,
    isKTX2File: true,
    enableDebug: false,
  });
}

/** Views of the binary chunk, some in place of others, one after the other, each at a multiple of 4. */
function packed(json, binary, views) {
  const parts = [];
  let at = 0;
  json.bufferViews.forEach((view, i) => {
    const {buffer = 0, byteOffset = 0, byteLength} = view;
    if (buffer !== 0) return;  // meshopt's, which holds nothing
    const bytes = views.get(i) ?? binary.subarray(byteOffset, byteOffset + byteLength);
    parts.push(bytes, Buffer.alloc((4 - bytes.length % 4) % 4));
    Object.assign(view, {byteOffset: at, byteLength: bytes.length});
    at += bytes.length + parts.at(-1).length;
  });
  json.buffers[0].byteLength = at;
  return Buffer.concat(parts);
}

/** Puts KTX2 in place of the PNG of all textures but palettes; returns the new binary chunk. */
async function withKtx2({json, binary}) {
  const names = uses(json), views = new Map();
  let any = false;
  for (const [number, texture] of (json.textures ?? []).entries()) {
    const image = json.images?.[texture.source];
    if (image?.mimeType !== 'image/png' && image?.mimeType !== 'image/ktx2') continue;
    if (texture.name?.startsWith(palette)) continue;
    const {byteOffset = 0, byteLength} = json.bufferViews[image.bufferView];
    if (!views.has(image.bufferView))
      views.set(
        image.bufferView, await coded(binary.subarray(byteOffset, byteOffset + byteLength), names.get(number) ?? []));
    image.mimeType = 'image/ktx2';
    texture.extensions = {...texture.extensions, KHR_texture_basisu: {source: texture.source}};
    delete texture.source;
    any = true;
  }
  if (!any) throw new Error('no picture to code');
  for (const list of ['extensionsUsed', 'extensionsRequired'])
    json[list] = [...new Set([...json[list] ?? [], 'KHR_texture_basisu'])];
  return packed(json, binary, views);
}

function written(json, binary) {
  const text = Buffer.from(JSON.stringify(json)),
        chunk = Buffer.concat([text, Buffer.alloc((4 - text.length % 4) % 4, ' ')]);
  const head = Buffer.alloc(20), between = Buffer.alloc(8);
  head.writeUInt32LE(0x46546c67, 0);
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(28 + chunk.length + binary.length, 8);
  head.writeUInt32LE(chunk.length, 12);
  head.writeUInt32LE(0x4e4f534a, 16);
  between.writeUInt32LE(binary.length, 0);
  between.writeUInt32LE(0x004e4942, 4);
  return Buffer.concat([head, chunk, between, binary]);
}

console.log = () => {};  // Basis Universal tells each step
const words = process.argv.slice(2);
if (words.length !== 2) {
  console.error('usage: node scripts/ktx2.mjs IN.glb OUT.glb');
  process.exit(2);
}
try {
  const file = opened(readFileSync(words[0]));
  const binary = await withKtx2(file);
  writeFileSync(words[1], written(file.json, binary));
} catch (fault) {
  console.error(`ktx2: ${words[0]}: ${fault.message}`);
  process.exit(1);
}
