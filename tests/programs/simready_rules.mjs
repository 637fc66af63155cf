// A .usda against those rules of SimReady Foundation [NVIDIA 2026] for props that a text can show: features FET_000,
// FET_001, FET_003 and FET_011. This is a reading of the published rules, not their validator: to pass here is no pass
// there.
//   node simready_rules.mjs SCENE.usda [BROKEN RULE...]   with rules: these and no others are broken
import assert from 'node:assert';
import {readFileSync} from 'node:fs';

const [file, ...expected] = process.argv.slice(2);
const text = readFileSync(file, 'utf8');

/**
 * @typedef {{kind: string, type: string, name: string, path: string, schemas: string[], references: string[],
 *            fields: Map<string, string>, children: Prim[], parent: Prim|null}} Prim
 */

/** The prims of a text as Pomona writes it: an attribute a line, a brace at the end of its line or alone. */
function parsed(lines) {
  const root = {
    kind: 'root',
    type: '',
    name: '',
    path: '',
    schemas: [],
    references: [],
    inherits: [],
    fields: new Map(),
    children: [],
    parent: null
  };
  let open = root, waiting = null, inMetadata = false, depthOfMetadata = 0;
  const takeMetadata = (prim, words) => {
    for (const [, list] of words.matchAll(/apiSchemas = \[(.*?)\]/g))
      prim.schemas.push(...list.match(/"[^"]*"/g).map((one) => one.slice(1, -1)));
    for (const [, path] of words.matchAll(/references = <([^>]*)>/g)) prim.references.push(path);
    for (const [, path] of words.matchAll(/inherits = <([^>]*)>/g)) prim.inherits.push(path);
  };
  for (const line of lines.slice(lines.findIndex((one) => one === ')') + 1)) {
    const words = line.trim();
    const head = /^(def|class|over) (?:(\w+) )?"([^"]*)"(.*)$/.exec(words);
    if (inMetadata) {
      takeMetadata(waiting, words);
      if (words.endsWith('{')) ++depthOfMetadata;
      if (words === '}') --depthOfMetadata;
      if (words === ')' && depthOfMetadata === 0) inMetadata = false;
    } else if (head) {
      waiting = {
        kind: head[1],
        type: head[2] ?? '',
        name: head[3],
        path: `${open.path}/${head[3]}`,
        schemas: [],
        references: [],
        inherits: [],
        fields: new Map(),
        children: [],
        parent: open
      };
      open.children.push(waiting);
      takeMetadata(waiting, head[4]);
      inMetadata = head[4].trim() === '(';
    } else if (words === '{') {
      open = waiting;
    } else if (words === '}') {
      open = open.parent;
    } else if (words) {
      const [, name, value] = /^(?:uniform )?(?:[\w[\]]+ )?([\w:.]+) = (.*)$/.exec(words) ?? [];
      if (name) open.fields.set(name, value);
    }
  }
  return root;
}

const lines = text.split('\n');
const root = parsed(lines);
const all = [];
(function gather(prim) {
  all.push(prim);
  prim.children.forEach(gather);
})(root);
const roots = root.children.filter((prim) => prim.kind !== 'class');
const at = new Map(all.map((prim) => [prim.path, prim]));
// What a piece inherits is composed with what it refers to.
for (const heir of all)
  for (const child of heir.inherits.flatMap((path) => at.get(path).children)) child.parent = at.get(heir.references[0]);
const header = lines.slice(0, lines.indexOf(')')).join('\n');
const applies = (prim, schema) => prim.schemas.includes(schema);
const numbers = (prim, field) =>
  (prim.fields.get(field)?.replace(/ \(interpolation.*$/, '').match(/-?[\d.]+(?:e-?\d+)?/g) ?? []).map(Number);
const meshes = all.filter((prim) => prim.type === 'Mesh');
const bodies = all.filter((prim) => applies(prim, 'PhysicsRigidBodyAPI'));
const colliders = all.filter((prim) => applies(prim, 'PhysicsCollisionAPI'));
const ancestors = (prim) => prim.parent ? [prim.parent, ...ancestors(prim.parent)] : [];
const descendants = (prim) => prim.children.flatMap((child) => [child, ...descendants(child)]);
const assets = [...text.matchAll(/@([^@\n]*)@/g)].map((found) => found[1]);

/** A physics material for the prim: its own binding, for physics or for all purposes. */
function physicsMaterial(prim) {
  const binding = prim.fields.get('material:binding:physics') ?? prim.fields.get('material:binding');
  if (!binding) return null;
  let place = prim;
  for (const step of binding.slice(1, -1).split('/'))
    place = step === '..' ? place?.parent : place?.children.find((child) => child.name === step);
  return place ?? null;
}

const hasPhysics = (material) => applies(material, 'PhysicsMaterialAPI') ||
  material.references.some((path) => at.has(path) && hasPhysics(at.get(path)));

/** Six times the volume of a mesh. */
function volume(mesh) {
  const points = numbers(mesh, 'points'), corners = numbers(mesh, 'faceVertexIndices');
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => points.slice(3 * corners[i + k], 3 * corners[i + k] + 3));
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

/** Each rule by its code: what is wrong, or nothing. */
const rules = {
  'NP.001': () => all.slice(1).filter((prim) => !/^[A-Za-z_][A-Za-z0-9_]*$/.test(prim.name)),
  'NP.007': () => assets.filter((path) => path.startsWith('/') || path.includes(':')),
  'AA.001': () => assets.filter((path) => !path.startsWith('./') && !path.startsWith('../')),
  'AA.002': () => assets.filter((path) => !/\.(png|jpg|jpeg|exr|usd|usda|usdc)$/.test(path)),
  'HI.011': () => all.slice(1).filter(
    (prim) => prim.kind === 'over' && !ancestors(prim).some((one) => one.type === 'Material' || one.name === 'Looks') &&
      !prim.parent.children.some((one) => one.kind === 'def' && one.name === prim.name)),
  'UN.001': () => /upAxis = "[YZ]"/.test(header) ? [] : ['no axis is up'],
  'UN.006': () => header.includes('upAxis = "Z"') ? [] : ['Z is not up'],
  'UN.007': () => header.includes('metersPerUnit = 1\n') ? [] : ['not in metres'],
  // Classes are abstract: they are not of the hierarchy that is composed.
  'HI.001': () => roots.length === 1 ? [] : roots,
  'HI.003': () => roots.filter((prim) => prim.type !== 'Xform'),
  'HI.004': () => roots.some((prim) => header.includes(`defaultPrim = "${prim.name}"`)) ? [] : ['no default prim'],
  'VG.001': () => meshes.length ? [] : ['no mesh'],
  'VG.MESH.001': () =>
    all.filter((prim) => ['Cube', 'Sphere', 'Cylinder', 'Cone', 'Capsule', 'NurbsPatch'].includes(prim.type)),
  'VG.002': () => meshes.filter((mesh) => {
    const points = numbers(mesh, 'points'), extent = numbers(mesh, 'extent');
    return [0, 1, 2].some((k) => {
      const values = points.filter((_, i) => i % 3 === k);
      const low = values.reduce((a, b) => Math.min(a, b)), high = values.reduce((a, b) => Math.max(a, b));
      return Math.abs(low - extent[k]) > 2e-7 || Math.abs(high - extent[3 + k]) > 2e-7;
    });
  }),
  'VG.014': () => meshes.filter((mesh) => {
    const counts = numbers(mesh, 'faceVertexCounts'), corners = numbers(mesh, 'faceVertexIndices'),
          points = numbers(mesh, 'points').length / 3;
    return counts.reduce((a, b) => a + b, 0) !== corners.length ||
      corners.some((corner) => corner < 0 || corner >= points);
  }),
  'VG.027': () => meshes.filter((mesh) => numbers(mesh, 'normals').length === 0),
  'VG.028': () => meshes.filter((mesh) => {
    const normals = numbers(mesh, 'normals');
    for (let i = 0; i < normals.length; i += 3)
      if (Math.abs(Math.hypot(normals[i], normals[i + 1], normals[i + 2]) - 1) > 2e-3) return true;
    return false;
  }),
  'VG.029': () => meshes.filter((mesh) => mesh.fields.get('doubleSided') !== '1' && !(volume(mesh) > 0)),
  'RB.001': () => bodies.length ? [] : ['nothing moves'],
  'RB.003': () => bodies.filter((prim) => prim.type !== 'Xform' && prim.type !== 'Mesh'),
  'RB.006': () => bodies.filter((prim) => ancestors(prim).some((one) => applies(one, 'PhysicsRigidBodyAPI'))),
  'RB.007': () => bodies.filter((prim) => !(numbers(prim, 'physics:mass')[0] > 0) || !applies(prim, 'PhysicsMassAPI')),
  'RB.008': () => bodies.filter(
    (prim) => prim.fields.has('physics:diagonalInertia') &&
      numbers(prim, 'physics:diagonalInertia').some((moment) => !(moment > 0))),
  'RB.COL.001': () => bodies.filter((prim) => !descendants(prim).some((one) => applies(one, 'PhysicsCollisionAPI'))),
  'RB.COL.002': () => colliders.filter(
    (prim) => !ancestors(prim).some((one) => applies(one, 'PhysicsRigidBodyAPI')) &&
      prim.fields.get('physics:approximation') !== '"none"'),
  'RB.COL.003': () => all.filter((prim) => applies(prim, 'PhysicsMeshCollisionAPI') && prim.type !== 'Mesh'),
  'RB.COL.004': () => all.filter((prim) => [...prim.fields.keys()].some((name) => name.startsWith('xformOp:scale'))),
  'PMT.001': () => colliders.filter((prim) => {
    const material = physicsMaterial(prim);
    return !material || !hasPhysics(material);
  }),
  'SL.001': () => meshes.filter(
    (mesh) => mesh.fields.get('purpose') !== '"guide"' &&
      ![mesh, ...ancestors(mesh)].some(
        (one) => one.schemas.some((schema) => schema.startsWith('SemanticsLabelsAPI:')))),
  'SL.003': () => all.filter(
    (prim) => [...prim.fields.keys()].some(
      (name) => name.startsWith('semantics:labels:') && !applies(prim, `SemanticsLabelsAPI:${name.slice(17)}`))),
  'SL.NV.002': () => text.includes('.timeSamples') ? ['labels change in time'] : [],
};

const broken = Object.entries(rules).map(([code, check]) => [code, check()]).filter(([, wrong]) => wrong.length);
const told = broken.map(([code, wrong]) => `${code}: ${wrong.slice(0, 3).map((one) => one.path ?? one).join(', ')}`);
assert.deepEqual(broken.map(([code]) => code), expected, told.join('\n'));
console.log(`${Object.keys(rules).length} rules, ${bodies.length} bodies, ${colliders.length} colliders`);
