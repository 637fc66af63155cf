// TinyUSDZ, a reader of USD that is not ours, composes a .usda and finds in it what the .glb of the same scene holds.
//   node usd_test.mjs SCENE.usda SCENE.glb LEVELS.usda INSTANCES.usda RIPENESSES.usda RIPENESSES.glb ATLAS.usda...
import assert from 'node:assert';
import {existsSync, readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';

const [sceneFile, glbFile, levelsFile, instancesFile, ripeFile, ripeGlbFile, ...atlasFiles] = process.argv.slice(2);

// TinyUSDZ is compiled for browsers; it asks for no more of one than this.
globalThis.window = globalThis;
Object.defineProperty(process, 'type', {value: 'renderer'});
const {default: tinyusdz} = await import('tinyusdz/tinyusdz.js');
const wasm = readFileSync(createRequire(import.meta.url).resolve('tinyusdz/tinyusdz.wasm'));
const usd = await tinyusdz({
  instantiateWasm(imports, done) {
    WebAssembly.instantiate(wasm, imports).then(({instance, module}) => done(instance, module));
    return {};
  },
});

function composed(text) {
  const layer = new usd.TinyUSDZLoaderNative();
  assert(layer.loadAsLayerFromBinary(new TextEncoder().encode(text), 'scene.usda'), layer.error());
  if (layer.hasReferences()) assert(layer.composeReferences(), layer.error());
  return layer;
}

// Everything below a node: names and places.
function* nodesOf(node, within = '') {
  const path = `${within}/${node.primName ?? node.nodeName}`;
  yield {path, node};
  for (const child of node.children ?? []) yield* nodesOf(child, path);
}

function gltfOf(file) {
  const bytes = readFileSync(file);
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)));
}
const gltf = gltfOf(glbFile);
const countOf = (accessor) => gltf.accessors[accessor].count;
const plain = (name) => name.replaceAll(/[^A-Za-z0-9]/g, '_');

// Its renderer takes colours from textures only; the connection to displayColor is checked as text.
const text = readFileSync(sceneFile, 'utf8');
const connection = 'color3f inputs:diffuseColor.connect = <../colors.outputs:result>';
assert(text.includes(connection));
const layer = composed(text.replaceAll(connection, 'color3f inputs:diffuseColor = (1, 1, 1)'));
assert(layer.layerToRenderScene(), layer.error());
const root = layer.getDefaultRootNode();
const nodes = [...nodesOf(root)];
assert.equal(root.primName ?? root.nodeName, 'Scene');

// Every instance of the glTF is there, and has its mesh.
const shown = gltf.nodes.filter((node) => node.mesh !== undefined);
for (const node of shown) {
  const found = nodes.filter(({path}) => path.endsWith(`/${plain(node.name)}`) && !path.includes('Looks'));
  assert(found.length >= 1, `${node.name} is not there`);
  const place = found.at(-1).node.localMatrix ?? found.at(-1).node.globalMatrix;
  if (place)
    [0, 1, 2].forEach(
      (k) => assert(Math.abs(place[12 + k] - (node.translation?.[k] ?? 0)) < 1e-6, `${node.name} lies elsewhere`));
}
const meshes = new Map(), shapes = new Set();
for (let i = 0; i < layer.numMeshes(); ++i) {
  // Its arrays lie in memory that moves when it grows.
  const {absPath, points, faceVertexIndices} = layer.getMesh(i);
  const [, name] = /^\/Pieces\/(\w+)\/hull_1$/.exec(absPath) ?? [];
  if (name) shapes.add(name);  // what neighbours have left of a piece's hull: nobody draws it
  else meshes.set(absPath, {points: points.slice(), corners: faceVertexIndices.length});
}
const placed = [...meshes.keys()].filter((path) => path.startsWith('/Scene/'));
assert.equal(placed.length, shown.length, 'a mesh for each instance');
// It composes no children of what is inherited, but finds the classes.
const inherited = [...text.matchAll(/prepend inherits = <\/Pieces\/(\w+)>/g)].map(([, name]) => name);
assert(inherited.length > 0);
assert.deepEqual(inherited.toSorted(), [...shapes].toSorted(), 'shapes of those that lie close');
for (const path of placed) {
  const name = path.split('/').at(-2);
  const node = shown.find((one) => plain(one.name) === name);
  const {primitives} = gltf.meshes[node.mesh];
  const mesh = meshes.get(path);
  assert.equal(mesh.points.length / 3, countOf(primitives[0].attributes.POSITION), `${name}: vertices`);
  assert.equal(mesh.corners, primitives.reduce((sum, one) => sum + countOf(one.indices), 0), `${name}: triangles`);
  const {min, max} = gltf.accessors[primitives[0].attributes.POSITION];
  for (let k = 0; k < 3; ++k) {
    let low = Infinity, high = -Infinity;
    for (let i = k; i < mesh.points.length; i += 3)
      low = Math.min(low, mesh.points[i]), high = Math.max(high, mesh.points[i]);
    assert(Math.abs(low - min[k]) < 1e-6 && Math.abs(high - max[k]) < 1e-6, `${name}: bounds`);
  }
}
console.log(`${placed.length} pieces as in the .glb`);

// What USD has names for. The reader says all of it again but for applied schemas.
const flat = composed(text).layerToString();
for (const word of
       ['metersPerUnit = 1', 'upAxis = "Y"', 'physics:mass', 'semantics:labels:category = ["tomato"]',
        'semantics:labels:part = ["gel"]', 'string boundCamera = "/Scene/view"', 'rel camera = </Scene/view>',
        'pomona cut tomato', 'UsdPrimvarReader_float3'])
  assert(flat.includes(word), `${word} is lost`);
for (const schema of
       ['PhysicsRigidBodyAPI', 'PhysicsMassAPI', 'PhysicsMaterialAPI', 'SemanticsLabelsAPI:category',
        'PhysicsMeshCollisionAPI', 'MaterialBindingAPI'])
  assert(text.includes(`"${schema}"`), `${schema} is not applied`);

// Levels of detail are variants, the finest chosen unless one says otherwise; instances a PointInstancer.
const withLevels = readFileSync(levelsFile, 'utf8');
const trianglesAt = (level) => {
  const chosen = composed(withLevels.replaceAll('string LOD = "LOD0"', `string LOD = "${level}"`));
  assert(chosen.composeVariants(), chosen.error());
  const drawn = chosen.layerToString().replaceAll(/def Mesh "hull_\d+"[^{]*\{[^}]*\}/g, '');
  const counts = drawn.match(/faceVertexCounts = \[.*?\]/g);
  assert.equal(counts.length, meshes.size, 'one level each');
  return counts.reduce((sum, list) => sum + list.split(',').length, 0);
};
const [fine, coarse, coarsest] = ['LOD0', 'LOD1', 'LOD2'].map(trianglesAt);
assert.equal(fine, [...meshes.values()].reduce((sum, mesh) => sum + mesh.corners / 3, 0));
assert(coarse < 0.6 * fine && coarsest < 0.7 * coarse, `triangles of levels: ${fine}, ${coarse}, ${coarsest}`);
const instanced = composed(readFileSync(instancesFile, 'utf8')).layerToString();
assert(instanced.includes('def PointInstancer "pieces"'));
assert.equal(/protoIndices = \[(.*?)\]/.exec(instanced)[1].split(',').length, shown.length);
assert.equal(/positions = \[(.*?)\]/.exec(instanced)[1].match(/\(/g).length, shown.length);
console.log('variants and instances');

// Ripeness is a variant set: each variant has a texture of its own for each piece, on the same places.
const ripeText = readFileSync(ripeFile, 'utf8');
const texturesAt = (ripeness) => {
  const chosen = composed(ripeText.replaceAll('string ripeness = "as_is"', `string ripeness = "${ripeness}"`));
  assert(chosen.composeVariants(), chosen.error());
  const seen = chosen.layerToString();
  const files = [...new Set([...seen.matchAll(/inputs:file = @(.*?)@/g)].map((found) => found[1]))];
  for (const file of files) assert(existsSync(join(dirname(ripeFile), file)), `${file} is not there`);
  return files;
};
const ripeGltf = gltfOf(ripeGlbFile);
const named = ripeGltf.extensions.KHR_materials_variants.variants.map((variant) => plain(variant.name));
assert.deepEqual(named, ['ripeness_0_2', 'ripeness_1_8']);
const byRipeness = ['as_is', ...named].map(texturesAt);
for (const files of byRipeness) assert.equal(files.length, ripeGltf.meshes.length, 'a texture for each piece');
assert.equal(new Set(byRipeness.flat()).size, ripeGltf.images.length, 'and as many in all as the .glb has');
console.log('ripenesses');

// Where maps tell looks, a mesh has one material, whose pictures are there.
for (const file of atlasFiles) {
  const words = readFileSync(file, 'utf8');
  const joined = composed(words.replaceAll(connection, 'color3f inputs:diffuseColor = (1, 1, 1)'));
  const flatter = joined.layerToString();
  for (const input of ['inputs:roughness.connect', 'inputs:clearcoat.connect'])
    assert(flatter.includes(input), `${file}: ${input} is lost`);
  assert(!words.includes('familyName = "materialBind"'), `${file}: several materials a mesh`);
  const pictures = [...new Set([...flatter.matchAll(/inputs:file = @(.*?)@/g)].map((found) => found[1]))];
  assert(pictures.length >= 2 && pictures.length <= 6, `${file}: ${pictures.length} pictures`);
  for (const picture of pictures) assert(existsSync(join(dirname(file), picture)), `${picture} is not there`);
  assert(joined.layerToRenderScene(), joined.error());
  const paths = Array.from({length: joined.numMeshes()}, (_, i) => joined.getMesh(i).absPath);
  assert.equal(
    paths.filter((path) => path.startsWith('/Scene/')).length, placed.length, `${file}: a mesh for each instance`);
}
console.log('one material a mesh');
