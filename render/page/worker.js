// The worker: unpacks the asset and lays it out for the card. The skin goes out as soon as its bytes are there, then what
// cut faces need.
'use strict';
onmessage = async ({data: text}) => {
  try {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    let fruit = null;
    const bytes = await Asset.unpacked(packed, (soFar, length) => {
      const head = fruit ? null : Asset.header(soFar, length);
      if (!head || length < Asset.surfacesEnd(head)) return;
      fruit = Asset.surfaces(soFar, head);
      const skin = Skin.built(fruit);
      postMessage({header: head.fields, skin}, [skin.buffer]);
    });
    Asset.addWindings(fruit);
    Asset.addLook(fruit, bytes, Asset.addNodes(fruit, bytes, Asset.surfacesEnd(Asset.header(bytes, bytes.length))));
    const {grid, cell, list, triangle, low, high} = LookUp.textures(fruit, LookUp.cells(fruit));
    const {noise, details, materials, guide, share, winding} = fruit;
    postMessage({grid, cell, list, triangle, low, high, noise, details, materials, guide, share, winding},
      [grid.buffer, cell.buffer, list.buffer, triangle.buffer, winding.buffer]);
  } catch (error) {
    postMessage({error: String(error && error.message || error)});
  }
};
