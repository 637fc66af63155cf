// Lets pieces fall in MuJoCo, and writes the .glb of the same pieces as they then lie, for others to draw:
// docs/guides/simulation.md.
//   node scripts/mujoco_glb.mjs MODEL.xml PIECES.glb SECONDS OUT.glb [FACE...]
// FACEs are cut faces, as cut_2, whose welds are let go at the start; "all" is all of them. Run where node_modules lies
// (npm ci).
import {readFileSync, writeFileSync} from 'node:fs';

import {opened, run} from '../tests/programs/mujoco.mjs';

const [xml, glb, seconds, out, ...faces] = process.argv.slice(2);
const simulation = opened(xml);
const {data, names} = simulation;
const welds = [...readFileSync(xml, 'utf8').matchAll(/<weld name="([^"]*)"/g)].map(([, name]) => name);
welds.forEach((name, i) => {
  if (faces.includes('all') || faces.some((face) => name.endsWith(`_${face}`))) data.eq_active[i] = 0;
});
run(simulation, Number(seconds));

// Bodies and meshes have the same origin and axes; the model's world has +Z up, that of glTF +Y.
const half = Math.SQRT1_2;
const turned = ([w, x, y, z]) => [half * (x - w), half * (y + z), half * (z - y), half * (w + x)];  // xyzw
const bytes = readFileSync(glb);
const length = bytes.readUInt32LE(12);
const json = JSON.parse(bytes.subarray(20, 20 + length));
const eye = json.nodes.find((node) => 'camera' in node);
for (const node of json.nodes) {
  const body = names.indexOf((node.name ?? '').replaceAll(/[^A-Za-z0-9]/g, '_'));
  if (body < 1 || node === eye) continue;
  const [x, y, z] = data.xpos.slice(3 * body, 3 * body + 3);
  node.translation = [x, z, -y];
  node.rotation = turned(data.xquat.slice(4 * body, 4 * body + 4));
}
const text = Buffer.from(JSON.stringify(json));
const padded = Buffer.concat([text, Buffer.alloc((4 - text.length % 4) % 4, ' ')]);
const head = Buffer.from(bytes.subarray(0, 20));
head.writeUInt32LE(bytes.length - length + padded.length, 8);
head.writeUInt32LE(padded.length, 12);
writeFileSync(out, Buffer.concat([head, padded, bytes.subarray(20 + length)]));
simulation.close();
