// The studio's worker: decompresses one asset after another and lays it out for the card.
import {laidOut} from '../../../render/page/laid_out.js';
import * as Asset from '../../../render/page/read_asset.js';
import * as Skin from '../../../render/page/skin.js';

onmessage = async ({data: {bytes: packed, number}}) => {
  try {
    const bytes = await Asset.unpacked(packed), head = Asset.header(bytes, bytes.length);
    const fruit = Asset.surfaces(bytes, head);
    const skin = Skin.built(fruit), outwards = Skin.outwards(skin);
    const glass = Skin.built({...fruit, hidden: new Uint8Array(fruit.hidden.length).fill(1)});
    Asset.addWindings(fruit);
    Asset.addLook(fruit, bytes, Asset.addNodes(fruit, bytes, Asset.surfacesEnd(head)));
    const {message: rest, transfer} = laidOut(fruit);
    transfer.push(skin.buffer, outwards.buffer, glass.buffer);
    postMessage({number, header: head.fields, skin, outwards, glass, rest}, {transfer});
  } catch (error) { postMessage({number, error: String(error && error.message || error)}); }
};
