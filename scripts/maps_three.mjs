// Draws a .glb with maps by three.js in a headless Chromium, on a table in the light of a room and a lamp:
// docs/reference/textures.md.
//   node scripts/maps_three.mjs FILE.glb PICTURE.png [rim|scene]
// "rim" looks from close by at the edge between the cut face and the skin, at 45 degrees to either; "scene" looks
// as the file's own camera does, from where all is in sight, and leaves all where it lies. Needs `npm ci` and chromium.
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';

import {launch} from '../tests/programs/browser.mjs';
import {served} from '../tests/programs/served.mjs';

const [glb, picture] = process.argv.slice(2, 4).map((path) => resolve(path));
const atRim = process.argv[4] === 'rim', asItLies = process.argv[4] === 'scene';
const [width, height] = asItLies ? [640, 480] : [480, 384];
const page = `<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,"><script type="importmap">
{"imports": {"three": "/node_modules/three/build/three.module.js",
  "three/addons/": "/node_modules/three/examples/jsm/"}}
</script><body style="margin: 0"><script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
const { scene: fruit, cameras } = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync('/scene.glb');
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(${width}, ${height});
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = THREE.PCFSoftShadowMap;
renderer.toneMapping = THREE.NeutralToneMapping;
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0xf7f3eb);
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.03).texture;
scene.environmentIntensity = 0.35;
if (!${asItLies}) fruit.rotation.x = -70 * Math.PI / 180;  // the face points up, like a half on a table
scene.add(fruit);
const box = new THREE.Box3().setFromObject(fruit, true), middle = box.getCenter(new THREE.Vector3());
const reach = box.getSize(new THREE.Vector3()).length() / 2;
const table = new THREE.Mesh(new THREE.PlaneGeometry(60 * reach, 60 * reach),
  new THREE.ShadowMaterial({ opacity: 0.28 }));
table.rotation.x = -Math.PI / 2;
table.position.set(middle.x, box.min.y, middle.z);
table.receiveShadow = true;
const sun = new THREE.DirectionalLight(0xfff6e8, 3);
sun.position.copy(middle).add(new THREE.Vector3(-0.42, 0.9, -0.42).multiplyScalar(6 * reach));
sun.target.position.copy(middle);
sun.castShadow = true;
sun.shadow.mapSize.set(1024, 1024);
sun.shadow.radius = 8;
sun.shadow.normalBias = 0.02 * reach;
Object.assign(sun.shadow.camera, { left: -3 * reach, right: 3 * reach, top: 3 * reach, bottom: -3 * reach,
  near: 0.1 * reach, far: 14 * reach });
fruit.traverse((part) => { part.castShadow = part.isMesh; });
scene.add(table, sun, sun.target);
/** Calls visit with the place of each vertex in the scene, one vector for all of them. */
function visitVertices(visit) {
  const place = new THREE.Vector3();
  fruit.updateMatrixWorld(true);
  fruit.traverse((part) => {
    for (let v = 0; part.isMesh && v < part.geometry.attributes.position.count; ++v)
      visit(place.fromBufferAttribute(part.geometry.attributes.position, v).applyMatrix4(part.matrixWorld));
  });
}
const camera = ${asItLies} ? cameras[0] :
  new THREE.PerspectiveCamera(25, ${width} / ${height}, 0.01 * reach, 100 * reach);
if (${asItLies}) {
  fruit.traverse((part) => { part.receiveShadow = part.isMesh; });
  camera.aspect = ${width} / ${height};
  camera.updateProjectionMatrix();
  const turn = camera.getWorldQuaternion(new THREE.Quaternion());
  const back = new THREE.Vector3(0, 0, 1).applyQuaternion(turn);
  // As near as shows every vertex, with a margin.
  const up = Math.tan(camera.fov * Math.PI / 360), across = up * camera.aspect;
  const turnBack = turn.clone().invert();
  let distance = 0;
  visitVertices((place) => {
    const { x, y, z } = place.sub(middle).applyQuaternion(turnBack);
    distance = Math.max(distance, z + 1.08 * Math.max(Math.abs(x) / across, Math.abs(y) / up));
  });
  camera.position.copy(middle).addScaledVector(back, distance);
} else {
  camera.position.copy(middle).add(new THREE.Vector3(0.3, 0.8, 1).normalize().multiplyScalar(4.3 * reach));
  camera.lookAt(middle);
}
if (${atRim}) {
  const face = new THREE.Vector3(0, 0, 1).applyEuler(fruit.rotation), at = new THREE.Vector3();
  let most = -Infinity;  // on the face, to the right in front
  visitVertices((place) => {
    const so = 1000 * place.dot(face) + place.x + place.z;
    if (so > most) { most = so; at.copy(place); }
  });
  const out = at.clone().sub(middle);
  out.addScaledVector(face, -out.dot(face)).normalize();
  camera.position.copy(at).add(face.clone().add(out).normalize().multiplyScalar(1.1 * reach));
  camera.fov = 20;
  camera.updateProjectionMatrix();
  camera.lookAt(at);
}
renderer.render(scene, camera);
window.drawn = true;
</script>`;
const files = await served((path) => path === '/' ? page : path === '/scene.glb' ? readFileSync(glb) : null);
const browser = await launch({flags: ['--hide-scrollbars']});
try {
  const tab = await browser.newPage();
  await tab.setViewport({width, height});
  const failed = new Promise((_, fail) => {
    tab.on('pageerror', fail);
    tab.on('response', (answer) => answer.ok() || fail(new Error(`there is no ${new URL(answer.url()).pathname}`)));
  });
  const drawn = tab.goto(files.url).then(() => tab.waitForFunction('window.drawn', {timeout: 200000}));
  await Promise.race([failed, drawn]);
  await tab.screenshot({path: picture});
} catch (error) {
  console.error(`maps_three: error: ${glb} was not drawn: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
  files.close();
}
