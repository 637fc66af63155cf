// The data of a whole asset, laid out for the card by a worker, for FruitTextures.takeRest().
import * as LookUp from './look_up.js';
import * as Spared from './spared.js';

/**
 * In it, nodes within spared parts are air.
 * @param {import('./types.d.ts').Fruit} fruit
 */
export function laidOut(fruit) {
  const {grid, cell, list, triangle, low, high} = LookUp.textures(fruit, LookUp.cells(fruit));
  const {noise, details, materials, guide, share} = fruit, spared = Spared.built(fruit);
  const winding = spared ? spared.free : fruit.winding;
  return {
    message: {grid, cell, list, triangle, low, high, noise, details, materials, guide, share, winding, spared},
    transfer: [grid.buffer, cell.buffer, list.buffer, triangle.buffer, winding.buffer]
  };
}
