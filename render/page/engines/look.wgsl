// The colour inside a fruit at any point, in WGSL: look.glsl word for word. docs/reference/asset.md tells how the four
// textures are made of an asset. The bindings are in a group of their own; change its number as you need.
struct Pomona {
  count: vec3f,  // nodes along each axis
  units: i32,    // of positions, to a cell
  low: vec3f,    // of all colours, linear
  high: vec3f,
}
@group(0) @binding(0) var pomona_grid: texture_3d<f32>;      // sRGB, alpha. Colours at nodes; alpha: 1 + the part there, of 255; 0 in air
@group(0) @binding(1) var pomona_linear: sampler;            // of the grid: linear, clamped
@group(0) @binding(2) var pomona_cell: texture_3d<u32>;      // x: first entry of the list; y: how many (bits 0-11), 1 + windings of 8 corners (2 bits each)
@group(0) @binding(3) var pomona_list: texture_2d<u32>;      // 2048 wide: triangles by cell
@group(0) @binding(4) var pomona_triangle: texture_2d<u32>;  // 4 texels each, 1024 a row: corners, hidden side, parts; front colours; back colours
@group(0) @binding(5) var<uniform> pomona: Pomona;

// Weights of a triangle's corners at its place nearest to the origin [Ericson 2005, 5.1.5].
fn pomona_nearest(a: vec3f, b: vec3f, c: vec3f) -> vec3f {
  let ab = b - a;
  let ac = c - a;
  let a1 = -dot(ab, a);
  let a2 = -dot(ac, a);
  if (a1 <= 0.0 && a2 <= 0.0) { return vec3f(1.0, 0.0, 0.0); }
  let b1 = -dot(ab, b);
  let b2 = -dot(ac, b);
  if (b1 >= 0.0 && b2 <= b1) { return vec3f(0.0, 1.0, 0.0); }
  let across_c = a1 * b2 - b1 * a2;
  if (across_c <= 0.0 && a1 >= 0.0 && b1 <= 0.0) {
    let w = a1 / (a1 - b1);
    return vec3f(1.0 - w, w, 0.0);
  }
  let c1 = -dot(ab, c);
  let c2 = -dot(ac, c);
  if (c2 >= 0.0 && c1 <= c2) { return vec3f(0.0, 0.0, 1.0); }
  let across_b = c1 * a2 - a1 * c2;
  if (across_b <= 0.0 && a2 >= 0.0 && c2 <= 0.0) {
    let w = a2 / (a2 - c2);
    return vec3f(1.0 - w, 0.0, w);
  }
  let across_a = b1 * c2 - c1 * b2;
  if (across_a <= 0.0 && b2 - b1 >= 0.0 && c1 - c2 >= 0.0) {
    let w = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return vec3f(0.0, 1.0 - w, w);
  }
  let sum = across_a + across_b + across_c;
  return vec3f(1.0 - across_b / sum - across_c / sum, across_b / sum, across_c / sum);
}

fn pomona_texel(number: u32, texel: u32) -> vec4u {
  return textureLoad(pomona_triangle, vec2u((number & 1023u) * 4u + texel, number >> 10u), 0);
}

// Ten bits each of the square roots of a colour.
fn pomona_color(bits: u32) -> vec3f {
  let root = vec3f(f32(bits & 1023u), f32((bits >> 10u) & 1023u), f32((bits >> 20u) & 1023u)) / 1023.0;
  return root * root;
}

// `side`: 2 * triangle, + 1 for its back.
fn pomona_side(side: u32, weight: vec3f) -> vec3f {
  let corner = pomona_texel(side >> 1u, 2u + (side & 1u));
  return weight.x * pomona_color(corner.x) + weight.y * pomona_color(corner.y) + weight.z * pomona_color(corner.z);
}

// A linear function through values at places around the origin, by least squares with weights 1 / (d^2 + 1/1000)^2:
// the sums that its normal equations need.
struct PomonaFit {
  one: vec4f,       // of w, w p
  diagonal: vec3f,  // of w x x, w y y, w z z
  beside: vec3f,    // of w x y, w x z, w y z
  value: vec3f,
  by_x: vec3f,
  by_y: vec3f,
  by_z: vec3f,
}

fn pomona_add(fit: ptr<function, PomonaFit>, place: vec3f, value: vec3f) {
  let d = dot(place, place) + 1e-3;
  let w = 1.0 / (d * d);
  let p = w * place;
  (*fit).one += vec4f(w, p);
  (*fit).diagonal += p * place;
  (*fit).beside += p.xxy * place.yzz;
  (*fit).value += w * value;
  (*fit).by_x += p.x * value;
  (*fit).by_y += p.y * value;
  (*fit).by_z += p.z * value;
}

// The function's value at the origin: z, y and x are eliminated in turn. A trace of stiffness keeps slopes that nothing
// determines at 0.
fn pomona_value(fit: PomonaFit) -> vec3f {
  let stiff = 1e-6 * fit.one.x;
  var xx = fit.diagonal.x + stiff;
  var yy = fit.diagonal.y + stiff;
  let zz = fit.diagonal.z + stiff;
  var xy = fit.beside.x;
  let xz = fit.beside.y;
  let yz = fit.beside.z;
  var o = fit.one.x;
  var x = fit.one.y;
  var y = fit.one.z;
  let z = fit.one.w;
  var v = fit.value;
  var vx = fit.by_x;
  var vy = fit.by_y;

  var s = z / zz;
  var sx = xz / zz;
  let sy = yz / zz;
  o -= s * z;
  x -= s * xz;
  y -= s * yz;
  v -= s * fit.by_z;
  xx -= sx * xz;
  xy -= sx * yz;
  vx -= sx * fit.by_z;
  yy -= sy * yz;
  vy -= sy * fit.by_z;
  s = y / yy;
  sx = xy / yy;
  o -= s * y;
  x -= s * xy;
  v -= s * vy;
  xx -= sx * xy;
  vx -= sx * vy;
  s = x / xx;
  return (v - s * vx) / (o - s * x);
}

// Rays to four corners of a cell that have the same z: how far they get, what they meet there, and what the boundary
// that they cross takes from the corners' windings.
struct PomonaRays {
  fraction: vec4f,  // 2 where nothing is met
  on_a: vec4f,      // weights of the corners there
  on_b: vec4f,
  side: vec4u,
  winding: vec4f,
}

fn pomona_meet(rays: ptr<function, PomonaRays>, x: vec4f, y: vec4f, z: f32, edge: mat3x3f, volume: f32, side: u32,
               step_over: f32, reach: f32) {
  // A ray passes through the triangle if it sees all edges turn the same way.
  let a = x * edge[0].x + y * edge[0].y + vec4f(z * edge[0].z);
  let b = x * edge[1].x + y * edge[1].y + vec4f(z * edge[1].z);
  let c = x * edge[2].x + y * edge[2].y + vec4f(z * edge[2].z);
  let sum = a + b + c;
  let fraction = vec4f(volume) / sum;
  let zero = vec4f(0.0);
  let one_way = (a >= zero) & (b >= zero) & (c >= zero);
  let other_way = (a <= zero) & (b <= zero) & (c <= zero);
  let meets = (one_way | other_way) & (fraction >= zero);
  (*rays).winding += select(zero, vec4f(step_over), meets & (fraction <= vec4f(1.0)));
  let nearer = meets & (fraction <= vec4f(reach)) & (fraction < (*rays).fraction);
  (*rays).fraction = select((*rays).fraction, fraction, nearer);
  (*rays).on_a = select((*rays).on_a, a / sum, nearer);
  (*rays).on_b = select((*rays).on_b, b / sum, nearer);
  (*rays).side = select((*rays).side, vec4u(side), nearer);
}

struct PomonaFound {
  inside: bool,  // false in air
  color: vec3f,  // linear
  part: i32,     // which part of the fruit it is
}

// `g`: the point in cells of the grid, (point - origin) / spacing.
fn pomona_look(g: vec3f) -> PomonaFound {
  var found = PomonaFound(false, vec3f(0.0), -1);
  if (any(g < vec3f(0.0)) || any(g >= pomona.count - 1.0)) { return found; }
  let cell = vec3i(g);
  let within = g - vec3f(cell);
  let entry = textureLoad(pomona_cell, cell, 0).xy;
  let count = entry.y & 4095u;
  if (count == 0u) {
    // No surface is near: all corners are seen.
    if (((entry.y >> 12u) & 3u) == 1u) { return found; }
    found.color = textureSampleLevel(pomona_grid, pomona_linear, (g + 0.5) / pomona.count, 0.0).rgb;
    found.part = i32(textureLoad(pomona_grid, cell, 0).a * 255.0 + 0.5) - 1;
    found.inside = true;
    return found;
  }

  // Look towards the corners, and for the nearest place of all.
  let x = vec4f(-within.x, 1.0 - within.x, -within.x, 1.0 - within.x);
  let y = vec4f(-within.y, -within.y, 1.0 - within.y, 1.0 - within.y);
  let z = vec2f(-within.z, 1.0 - within.z);
  let shift = vec4u(12u, 14u, 16u, 18u);
  let none = vec4f(0.0);
  var low = PomonaRays(vec4f(2.0), none, none, vec4u(0u), vec4f((vec4u(entry.y) >> shift) & vec4u(3u)) - 1.0);
  var high = PomonaRays(vec4f(2.0), none, none, vec4u(0u), vec4f((vec4u(entry.y) >> (shift + 8u)) & vec4u(3u)) - 1.0);
  var nearest = 1e9;
  var nearest_place = vec3f(0.0);
  var nearest_weight = vec3f(0.0);
  var nearest_side = 0u;
  let base = cell * pomona.units;
  let unit = 1.0 / f32(pomona.units);
  let reach = 1.0 + 1.5 * unit;  // rounding may have put a corner behind a surface that was behind it
  for (var i = entry.x; i < entry.x + count; i++) {
    let number = textureLoad(pomona_list, vec2u(i & 2047u, i >> 11u), 0).x;
    let t = pomona_texel(number, 0u);
    let u = pomona_texel(number, 1u);
    let a = (vec3f(vec3i(vec3u(t.x & 65535u, t.x >> 16u, t.y & 65535u)) - base) + 0.5) * unit - within;
    let b = (vec3f(vec3i(vec3u(t.y >> 16u, t.z & 65535u, t.z >> 16u)) - base) + 0.5) * unit - within;
    let c = (vec3f(vec3i(vec3u(t.w & 65535u, t.w >> 16u, u.x & 65535u)) - base) + 0.5) * unit - within;
    let edge = mat3x3f(cross(b, c), cross(c, a), cross(a, b));
    let volume = dot(a, edge[0]);
    let hidden = (u.x >> 16u) & 3u;
    let side = 2u * number + select(1u, 0u, volume < 0.0);
    let step_over = select(select(1.0, -1.0, (volume < 0.0) == (hidden == 1u)), 0.0, hidden == 0u);
    pomona_meet(&low, x, y, z.x, edge, volume, side, step_over, reach);
    pomona_meet(&high, x, y, z.y, edge, volume, side, step_over, reach);

    let weight = pomona_nearest(a, b, c);
    let place = weight.x * a + weight.y * b + weight.z * c;
    let squared = dot(place, place);
    if (squared < nearest) {
      let front = volume <= 0.0;
      nearest = squared;
      nearest_place = place;
      nearest_weight = weight;
      nearest_side = 2u * number + select(1u, 0u, front);
      found.part = i32(select(u.y >> 16u, u.y, front) & 65535u);
    }
  }
  if (abs(dot(low.winding + high.winding, vec4f(1.0))) < 4.0) {
    found.part = -1;
    return found;
  }

  // Fit what they see.
  let zero = vec3f(0.0);
  var fit = PomonaFit(vec4f(0.0), zero, zero, zero, zero, zero, zero);
  pomona_add(&fit, nearest_place, pomona_side(nearest_side, nearest_weight));
  for (var k = 0; k < 8; k++) {
    let upper = k >= 4;
    let i = k & 3;
    let towards = vec3f(x[i], y[i], select(z.x, z.y, upper));
    let fraction = select(low.fraction[i], high.fraction[i], upper);
    if (fraction < 2.0) {
      let on = select(vec2f(low.on_a[i], low.on_b[i]), vec2f(high.on_a[i], high.on_b[i]), upper);
      let side = select(low.side[i], high.side[i], upper);
      pomona_add(&fit, fraction * towards, pomona_side(side, vec3f(on, 1.0 - on.x - on.y)));
    } else {
      let value = textureLoad(pomona_grid, cell + vec3i(k & 1, (k >> 1u) & 1, k >> 2u), 0);
      if (value.a > 0.0) { pomona_add(&fit, towards, value.rgb); }
    }
  }
  found.color = clamp(pomona_value(fit), pomona.low, pomona.high);
  found.inside = true;
  return found;
}
