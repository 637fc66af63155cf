// The studio's worker: unpacks one asset after another and lays it out for the card.
import * as LookUp from '../../../render/page/look_up.js';
import * as Asset from '../../../render/page/read_asset.js';
import * as Skin from '../../../render/page/skin.js';
import * as Spared from '../../../render/page/spared.js';

onmessage = async ({data: {bytes: packed, number}}) => {
  try {
    const bytes = await Asset.unpacked(packed), head = Asset.header(bytes, bytes.length), fruit = Asset.surfaces(bytes, head);
    const skin = Skin.built(fruit), outwards = Skin.outwards(skin), glass = Skin.built({...fruit, hidden: new Uint8Array(fruit.hidden.length).fill(1)});
    Asset.addWindings(fruit);
    Asset.addLook(fruit, bytes, Asset.addNodes(fruit, bytes, Asset.surfacesEnd(head)));
    const {grid, cell, list, triangle, low, high} = LookUp.textures(fruit, LookUp.cells(fruit));
    const {noise, details, materials, guide, share} = fruit, spared = Spared.built(fruit), winding = spared ? spared.free : fruit.winding;
    postMessage({number, header: head.fields, skin, outwards, glass, rest: {grid, cell, list, triangle, low, high, noise, details, materials, guide, share, winding, spared}},
      [skin.buffer, outwards.buffer, glass.buffer, grid.buffer, cell.buffer, list.buffer, triangle.buffer, winding.buffer]);
  } catch (error) {
    postMessage({number, error: String(error && error.message || error)});
  }
};
