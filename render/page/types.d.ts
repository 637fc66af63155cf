// What several scripts hand each other. Lengths are in cells of the asset's grid, where nothing else is said.

/** x, y and z. */
export type Point = number[];
export type Numbers = ArrayLike<number>;
/** Sixteen numbers, column after column. */
export type Matrix = Float32Array;

/** Of an asset, docs/reference/asset.md. */
export interface AssetHeader {
  format: number;
  thirds: number;
  /** Metres. */
  origin: Point;
  /** Metres. */
  spacing: number;
  count: number[];
  units: number;
  vertices: number;
  triangles: number;
  parts: string[];
  spared?: number[];
  shells?: {count: number; nearly_as_much: number};
  tiles?: {side: number; colors: number}[];
  texels: number[];
  skin_shares: number;
  guide?: {stride: number; unit: number; count: number[]; deepest: number};
}

/** An asset as read_asset.js has taken it apart; names and orders are those of docs/reference/asset.md. */
export interface Fruit {
  header: AssetHeader;
  /** Nodes along each axis. */
  count: number[];
  /** Of positions, to a cell. */
  units: number;
  position: Uint16Array;
  /** Bytes of sRGB, three a vertex. */
  front: Uint8Array;
  back: Uint8Array;
  /** Three corners each, counter-clockwise seen from the front. */
  triangle: Uint32Array;
  /** Per triangle: 0 no side faces air, 1 the front does, 2 the back. */
  hidden: Uint8Array;
  /** Per triangle: of the front, of the back. */
  part: Uint16Array[];
  /** Per node: how often the boundary winds around it. */
  winding: Int8Array;
  /** Per node: 1 + its part, 0 in air. */
  nodePart: Uint8Array;
  /** Red, green and blue of all nodes, bytes of sRGB. */
  nodeColor: Uint8Array[];
  noise: Float32Array;
  details: Float32Array;
  materials: Float32Array;
  skinShare: Uint8Array;
  guide?: Float32Array;
  share?: Uint8Array;
  /** Per triangle: which shell it is of, from 1; 0 of none. */
  shell?: Uint16Array;
}

/** Triangles by cell (look_up.js). */
export interface CellLists {
  first: Uint32Array;
  list: Uint32Array;
}

/** Of all colours, linear. */
export interface ColorRange {
  low: number[];
  high: number[];
}

/** What bounds a thing: its middle, its largest side, and as far as its corners are from the middle. */
export interface Frame {
  middle: Point;
  size: number;
  reach: number;
}

/** Where a knife lies: a place on its plane, directions, half its side. */
export interface KnifeFrame {
  origin: Point;
  n: Point;
  u: Point;
  v: Point;
  reach: number;
}

/** A shell around what knives spare: points within it and of it, three numbers each, and some that stand for it. */
export interface Shell {
  points: Float32Array;
  rim: Float32Array;
  samples: Point[];
}

/** Which cell has all of a shell, and whether a knife passes through it. */
export interface Home {
  cell: number;
  isCut: boolean;
}

/** What knives leave: the side of each knife (+1, -1), the same as bits, its middle, and points that stand for it. */
export interface Piece {
  keep: number[];
  cell: number;
  middle: Point;
  points: Point[];
}

/** A skin, ten numbers a corner (skin.js), and which corners are triangles. */
export interface JoinedSkin {
  skin: Float32Array;
  index: Uint32Array;
}

/** Of a page's scene (render/page/page_scene.h), as far as it is read. */
export interface SceneHeader {
  fruits: {units: number; texels: number[]}[];
  solids: {vertices: number; triangles: number; fruit: number}[];
}
