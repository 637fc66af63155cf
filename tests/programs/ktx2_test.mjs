// scripts/ktx2.mjs codes the pictures of a .glb as KTX2: the same bytes again, sound by the glTF validator and by a
// reader of KTX2, with all levels; three_test.mjs draws it. What is no such file is told, with the status for it.
//   node ktx2_test.mjs TEXTURED.glb PALETTE.glb FOLDER
import validator from 'gltf-validator';
import {read} from 'ktx-parse';
import assert from 'node:assert';
import {spawnSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [textured, palette, folder] = process.argv.slice(2).map((path) => resolve(path));
const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
mkdirSync(folder, {recursive: true});
const script = (...words) => spawnSync('node', [join(root, 'scripts/ktx2.mjs'), ...words], {encoding: 'utf8'});
const made = (name) => {
  const file = join(folder, name), {status, stderr} = script(textured, file);
  assert.equal(status, 0, stderr);
  return readFileSync(file);
};
const bytes = made('small-ktx2.glb');
assert(bytes.equals(made('again.glb')), 'the same bytes again');

// The validator of npm knows no KTX2: of what it says of such pictures, their kind alone may be.
const {issues} =
  await validator.validateBytes(new Uint8Array(bytes), {format: 'glb', maxIssues: 1000, writeTimestamp: false});
const unknown =
  ({code, pointer}) => ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT'].includes(code) && /^\/images\//.test(pointer);
assert.deepEqual(issues.messages.filter((message) => message.severity < 2 && !unknown(message)), []);

const length = bytes.readUInt32LE(12), json = JSON.parse(bytes.toString('utf8', 20, 20 + length));
const before = readFileSync(textured), plain = JSON.parse(before.toString('utf8', 20, 20 + before.readUInt32LE(12)));
assert(json.extensionsRequired.includes('KHR_texture_basisu'));
assert.equal(json.textures.length, plain.textures.length);
for (const [number, {source, extensions}] of json.textures.entries()) {
  assert.equal(source, undefined, 'no picture beside that of the extension');
  const image = json.images[extensions.KHR_texture_basisu.source], view = json.bufferViews[image.bufferView];
  assert.equal(extensions.KHR_texture_basisu.source, plain.textures[number].source);
  assert.equal(image.mimeType, 'image/ktx2');
  const at = 28 + length + view.byteOffset, ktx = read(new Uint8Array(bytes.subarray(at, at + view.byteLength)));
  assert.equal(ktx.vkFormat, 0, 'to be transcoded');
  assert.equal(ktx.levels.length, 1 + Math.log2(Math.max(ktx.pixelWidth, ktx.pixelHeight)), 'all levels');
}

// Meshes are as they were.
const numbers = (file, gltf, accessor) => {
  const view = gltf.bufferViews[gltf.accessors[accessor].bufferView];
  const at = 28 + file.readUInt32LE(12) + (view.byteOffset ?? 0);
  return file.subarray(at, at + view.byteLength);
};
plain.accessors.forEach((_, i) => assert(numbers(before, plain, i).equals(numbers(bytes, json, i)), `accessor ${i}`));

const refused = (status, told, ...words) => {
  const found = script(...words);
  assert.equal(found.status, status, words.join(' '));
  assert.match(found.stderr, told);
};
const broken = join(folder, 'broken.glb'), never = join(folder, 'never.glb');
refused(2, /usage/, textured);
refused(1, /no such file/, join(folder, 'none.glb'), never);
refused(1, /no picture to code/, palette, never);  // each texel is a look
for (const cut of [0, 11, 30, before.length - 1]) {
  writeFileSync(broken, before.subarray(0, cut));
  refused(1, /no \.glb/, broken, never);
}
const long = Buffer.from(before);
long.writeUInt32LE(0x7fffffff, 12);
writeFileSync(broken, long);
refused(1, /ends too soon/, broken, never);
console.log(`KTX2: ${json.images.length} pictures, ${before.length} bytes become ${bytes.length}`);
