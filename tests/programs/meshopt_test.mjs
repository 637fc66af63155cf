// What --compress meshopt codes is, decoded by another program's decoder, the mesh that the plain file has.
//   node meshopt_test.mjs PLAIN.glb CODED.glb
import assert from 'node:assert';
import {readFileSync} from 'node:fs';
import {MeshoptDecoder} from 'three/examples/jsm/libs/meshopt_decoder.module.js';

await MeshoptDecoder.ready;

function opened(file) {
  const bytes = readFileSync(file), length = bytes.readUInt32LE(12);
  return {gltf: JSON.parse(bytes.subarray(20, 20 + length)), buffer: new Uint8Array(bytes.subarray(28 + length))};
}

const kinds = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array
};
const widths = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4
};

/** The numbers of an accessor, whatever way they are coded. */
function numbersOf({gltf, buffer}, index) {
  const accessor = gltf.accessors[index], view = gltf.bufferViews[accessor.bufferView];
  const coded = view.extensions?.EXT_meshopt_compression;
  let bytes = buffer.subarray(view.byteOffset ?? 0, (view.byteOffset ?? 0) + view.byteLength);
  if (coded) {
    bytes = new Uint8Array(coded.count * coded.byteStride);
    MeshoptDecoder.decodeGltfBuffer(
      bytes, coded.count, coded.byteStride, buffer.subarray(coded.byteOffset, coded.byteOffset + coded.byteLength),
      coded.mode);
  }
  const Kind = kinds[accessor.componentType], width = widths[accessor.type];
  const stride = view.byteStride ?? Kind.BYTES_PER_ELEMENT * width;
  const list = [];
  for (let i = 0; i < accessor.count; ++i) {
    const start = (accessor.byteOffset ?? 0) + i * stride;
    list.push(...new Kind(bytes.slice(start, start + width * Kind.BYTES_PER_ELEMENT).buffer));
  }
  return list;
}

const [plain, coded] = process.argv.slice(2).map(opened);
assert.deepEqual(coded.gltf.extensionsRequired.toSorted(), ['EXT_meshopt_compression', 'KHR_mesh_quantization']);
assert.equal(coded.gltf.meshes.length, plain.gltf.meshes.length);
const scaleOf =
  new Map(coded.gltf.nodes.filter((node) => node.mesh !== undefined).map((node) => [node.mesh, node.scale[0]]));
let vertices = 0;
plain.gltf.meshes.forEach((mesh, m) => {
  const other = coded.gltf.meshes[m];
  mesh.primitives.forEach((primitive, p) => {
    const place = numbersOf(plain, primitive.attributes.POSITION),
          steps = numbersOf(coded, other.primitives[p].attributes.POSITION);
    const scale = scaleOf.get(m);
    place.forEach(
      (value, i) =>
        assert(Math.abs(value - steps[i] * scale) <= 0.51 * scale, `${mesh.name}: place of vertex ${i / 3 | 0}`));
    const color = numbersOf(plain, primitive.attributes.COLOR_0),
          codedColor = numbersOf(coded, other.primitives[p].attributes.COLOR_0);
    color.forEach((value, i) => assert(Math.abs(value - codedColor[i]) <= 17, `${mesh.name}: colour`));
    assert.deepEqual(
      numbersOf(coded, other.primitives[p].attributes._PART), numbersOf(plain, primitive.attributes._PART));
    // The same triangles, in another order, from other corners.
    const triangles = (list) => {
      const all = [];
      for (let i = 0; i < list.length; i += 3) {
        const t = list.slice(i, i + 3), k = t.indexOf(Math.min(...t));
        all.push([...t.slice(k), ...t.slice(0, k)].join());
      }
      return all.sort();
    };
    assert.deepEqual(
      triangles(numbersOf(coded, other.primitives[p].indices)), triangles(numbersOf(plain, primitive.indices)));
    vertices += place.length / 3;
  });
});
console.log(`${plain.gltf.meshes.length} meshes, ${vertices} vertices as in the plain file`);
