// The worker: decompresses the asset and lays it out for the card. It sends the skin as soon as its bytes are there,
// then the data of cut faces.
import {laidOut} from './laid_out.js';
import * as Asset from './read_asset.js';
import * as ScenePieces from './read_scene.js';
import * as Skin from './skin.js';

/** @import {Fruit} from './types.d.ts' */

/**
 * Five characters for four bytes (page_text.cpp).
 * @param {string} text
 */
function bytesOf(text) {
  const bytes = new Uint8Array(text.length / 5 * 4), view = new DataView(bytes.buffer);
  for (let i = 0, at = 0; i + 5 <= text.length; i += 5, at += 4) {
    let four = 0;
    for (let k = 0; k < 5; ++k) {
      const c = text.charCodeAt(i + k);
      four = four * 85 + c - 40 - (c > 60 ? 1 : 0) - (c > 92 ? 1 : 0);
    }
    view.setUint32(at, four);
  }
  return bytes;
}

/**
 * A fruit: its skin as soon as possible, then the data of cut faces.
 * @param {number} job
 * @param {Uint8Array} packed
 */
async function unpackFruit(job, packed) {
  let fruit = /** @type {Fruit | null} */ (null);
  const bytes = await Asset.unpacked(packed, (soFar, length) => {
    const head = fruit ? null : Asset.header(soFar, length);
    if (!head || length < Asset.surfacesEnd(head)) return;
    fruit = Asset.surfaces(soFar, head);
    const {skin, index} = Skin.joined(Skin.built(fruit)), outwards = Skin.outwards(skin, index);
    postMessage(
      {job, header: head.fields, skin, index, outwards}, {transfer: [skin.buffer, index.buffer, outwards.buffer]});
  });
  const head = Asset.header(bytes, bytes.length);
  if (!fruit || !head) throw new Error('the asset is cut off');
  Asset.addWindings(fruit);
  Asset.addLook(fruit, bytes, Asset.addNodes(fruit, bytes, Asset.surfacesEnd(head)));
  const {message, transfer} = laidOut(fruit);
  postMessage({job, header: fruit.header, ...message}, {transfer});
}

/**
 * A scene: all of its pieces' meshes.
 * @param {number} job
 * @param {Uint8Array} packed
 */
async function unpackScene(job, packed) {
  const scene = ScenePieces.decoded(await Asset.unpacked(packed, null, 2));
  const solids = scene.solids.map((solid) => ({...solid, outwards: Skin.outwards(solid.skin, solid.index)}));
  const transfer = solids.flatMap(({skin, index, outwards}) => [skin.buffer, index.buffer, outwards.buffer]);
  postMessage({job, ...scene, solids}, {transfer});
}

// From now on it receives messages, also while the page is busy.
setTimeout(() => postMessage({isUp: true}));

onmessage = async ({data: {job, text, length, isScene}}) => {
  try {
    await (isScene ? unpackScene : unpackFruit)(job, bytesOf(text).subarray(0, length));
  } catch (error) { postMessage({job, error: String(error && error.message || error)}); }
};
