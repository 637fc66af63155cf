// Cut faces in three.js: a material that colours any surface inside a fruit, from an asset (.pomona, or a .glb that
// contains one). Needs read_asset.js and look_up.js beside it, and the text of look.glsl.
import * as THREE from 'three';

import * as LookUp from './look_up.js';
import * as Asset from './read_asset.js';

/** The decompressed asset in a loaded .glb; null without one. `gltf`: the result of GLTFLoader. */
export async function assetOf(gltf) {
  const {json} = gltf.parser, extension = json.extensions && json.extensions.POMONA_cuttable;
  return extension ? unpackedAsset(new Uint8Array(await gltf.parser.getDependency('bufferView', extension.bufferView)))
                   : null;
}

/** The asset from the bytes of a .pomona. */
export async function unpackedAsset(packed) { return Asset.decoded(await Asset.unpacked(packed)); }

function texture(Kind, data, size, format, type, internalFormat, colorSpace = THREE.NoColorSpace) {
  const made = new Kind(data, ...size);
  const filter = internalFormat ? THREE.NearestFilter : THREE.LinearFilter;
  Object.assign(made, {
    format,
    type,
    internalFormat,
    colorSpace,
    minFilter: filter,
    magFilter: filter,
    unpackAlignment: 1,
    generateMipmaps: false,
    needsUpdate: true
  });
  return made;
}

/** A material for surfaces in the fruit's own frame, metres; places in air are discarded. */
export function cutMaterial(fruit, look) {
  const {header, count, units} = fruit;
  const {grid, cell, list, triangle, low, high} = LookUp.textures(fruit, LookUp.cells(fruit));
  const {Data3DTexture, DataTexture, UnsignedIntType} = THREE;
  const uniforms = {
    pomona_grid:
      texture(Data3DTexture, grid, count, THREE.RGBAFormat, THREE.UnsignedByteType, null, THREE.SRGBColorSpace),
    pomona_cell: texture(Data3DTexture, cell, count, THREE.RGIntegerFormat, UnsignedIntType, 'RG32UI'),
    pomona_list:
      texture(DataTexture, list, [2048, list.length / 2048], THREE.RedIntegerFormat, UnsignedIntType, 'R32UI'),
    pomona_triangle: texture(
      DataTexture, triangle, [4096, triangle.length / (4 * 4096)], THREE.RGBAIntegerFormat, UnsignedIntType,
      'RGBA32UI'),
    pomona_count: new THREE.Vector3(...count),
    pomona_units: units,
    pomona_low: new THREE.Vector3(...low),
    pomona_high: new THREE.Vector3(...high),
    lattice_origin: new THREE.Vector3(...header.origin),
    lattice_spacing: header.spacing,
  };
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    side: THREE.DoubleSide,
    uniforms: Object.fromEntries(Object.entries(uniforms).map(([name, value]) => [name, {value}])),
    vertexShader: `uniform vec3 lattice_origin;
      uniform float lattice_spacing;
      out vec3 in_cells;
      void main() {
        vec4 place = modelMatrix * vec4(position, 1.0);
        in_cells = (place.xyz - lattice_origin) / lattice_spacing;
        gl_Position = projectionMatrix * viewMatrix * place;
      }`,
    fragmentShader: `precision highp float;
      precision highp int;
      ${look}
      in vec3 in_cells;
      out vec4 shown;
      void main() {
        vec3 color;
        int part;
        if (!pomona_look(in_cells, color, part)) discard;
        shown = linearToOutputTexel(vec4(color, 1.0));
      }`,
  });
}
