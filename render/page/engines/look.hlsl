// The colour inside a fruit at any point, in HLSL (shader model 5 or later; Unreal, Unity, Direct3D): look.glsl word for
// word. docs/reference/asset.md tells how the four textures are made of an asset.
Texture3D<float4> pomona_grid;      // sRGB, alpha. Colours at nodes; alpha: 1 + the part there, of 255; 0 in air
SamplerState pomona_linear;         // of the grid: linear, clamped
Texture3D<uint2> pomona_cell;       // x: first entry of the list; y: how many (bits 0-11), 1 + windings of 8 corners (2 bits each)
Texture2D<uint> pomona_list;        // 2048 wide: triangles by cell
Texture2D<uint4> pomona_triangle;   // 4 texels each, 1024 a row: corners, hidden side, parts; front colours; back colours
cbuffer pomona {
  float3 pomona_count;              // nodes along each axis
  int pomona_units;                 // of positions, to a cell
  float3 pomona_low;                // of all colours, linear
  float3 pomona_high;
};

// Weights of a triangle's corners at its place nearest to the origin [Ericson 2005, 5.1.5].
float3 pomona_nearest(float3 a, float3 b, float3 c) {
  float3 ab = b - a, ac = c - a;
  float a1 = -dot(ab, a), a2 = -dot(ac, a);
  if (a1 <= 0.0 && a2 <= 0.0) return float3(1.0, 0.0, 0.0);
  float b1 = -dot(ab, b), b2 = -dot(ac, b);
  if (b1 >= 0.0 && b2 <= b1) return float3(0.0, 1.0, 0.0);
  float across_c = a1 * b2 - b1 * a2;
  if (across_c <= 0.0 && a1 >= 0.0 && b1 <= 0.0) {
    float w = a1 / (a1 - b1);
    return float3(1.0 - w, w, 0.0);
  }
  float c1 = -dot(ab, c), c2 = -dot(ac, c);
  if (c2 >= 0.0 && c1 <= c2) return float3(0.0, 0.0, 1.0);
  float across_b = c1 * a2 - a1 * c2;
  if (across_b <= 0.0 && a2 >= 0.0 && c2 <= 0.0) {
    float w = a2 / (a2 - c2);
    return float3(1.0 - w, 0.0, w);
  }
  float across_a = b1 * c2 - c1 * b2;
  if (across_a <= 0.0 && b2 - b1 >= 0.0 && c1 - c2 >= 0.0) {
    float w = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return float3(0.0, 1.0 - w, w);
  }
  float sum = across_a + across_b + across_c;
  return float3(1.0 - across_b / sum - across_c / sum, across_b / sum, across_c / sum);
}

uint4 pomona_texel(uint number, uint texel) {
  return pomona_triangle.Load(int3(int((number & 1023u) * 4u + texel), int(number >> 10), 0));
}

// Ten bits each of the square roots of a colour.
float3 pomona_color(uint bits) {
  float3 root = float3(float(bits & 1023u), float((bits >> 10) & 1023u), float((bits >> 20) & 1023u)) / 1023.0;
  return root * root;
}

// `side`: 2 * triangle, + 1 for its back.
float3 pomona_side(uint side, float3 weight) {
  uint4 corner = pomona_texel(side >> 1, 2u + (side & 1u));
  return weight.x * pomona_color(corner.x) + weight.y * pomona_color(corner.y) + weight.z * pomona_color(corner.z);
}

// A linear function through values at places around the origin, by least squares with weights 1 / (d^2 + 1/1000)^2:
// the sums that its normal equations need.
struct PomonaFit {
  float4 one;                  // of w, w p
  float3 diagonal, beside;     // of w x x, w y y, w z z; of w x y, w x z, w y z
  float3 value, by_x, by_y, by_z;
};

void pomona_add(inout PomonaFit fit, float3 place, float3 value) {
  float d = dot(place, place) + 1e-3, w = 1.0 / (d * d);
  float3 p = w * place;
  fit.one += float4(w, p);
  fit.diagonal += p * place;
  fit.beside += p.xxy * place.yzz;
  fit.value += w * value;
  fit.by_x += p.x * value;
  fit.by_y += p.y * value;
  fit.by_z += p.z * value;
}

// The function's value at the origin: z, y and x are eliminated in turn. A trace of stiffness keeps slopes that nothing
// determines at 0.
float3 pomona_value(PomonaFit fit) {
  float stiff = 1e-6 * fit.one.x;
  float xx = fit.diagonal.x + stiff, yy = fit.diagonal.y + stiff, zz = fit.diagonal.z + stiff;
  float xy = fit.beside.x, xz = fit.beside.y, yz = fit.beside.z;
  float o = fit.one.x, x = fit.one.y, y = fit.one.z, z = fit.one.w;
  float3 v = fit.value, vx = fit.by_x, vy = fit.by_y;

  float s = z / zz, sx = xz / zz, sy = yz / zz;
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
  float4 fraction, on_a, on_b;  // 2 where nothing is met; weights of the corners there
  uint4 side;
  float4 winding;
};

void pomona_meet(inout PomonaRays rays, float4 x, float4 y, float z, float3 edge_a, float3 edge_b, float3 edge_c,
                 float volume, uint side, float step_over, float reach) {
  // A ray passes through the triangle if it sees all edges turn the same way.
  float4 a = x * edge_a.x + y * edge_a.y + z * edge_a.z;
  float4 b = x * edge_b.x + y * edge_b.y + z * edge_b.z;
  float4 c = x * edge_c.x + y * edge_c.y + z * edge_c.z;
  float4 sum = a + b + c, fraction = volume / sum;
  [unroll] for (int i = 0; i < 4; ++i) {
    bool meets = ((a[i] >= 0.0 && b[i] >= 0.0 && c[i] >= 0.0) || (a[i] <= 0.0 && b[i] <= 0.0 && c[i] <= 0.0)) &&
                 fraction[i] >= 0.0;
    if (meets && fraction[i] <= 1.0) rays.winding[i] += step_over;
    if (!meets || !(fraction[i] <= reach) || !(fraction[i] < rays.fraction[i])) continue;
    rays.fraction[i] = fraction[i];
    rays.on_a[i] = a[i] / sum[i];
    rays.on_b[i] = b[i] / sum[i];
    rays.side[i] = side;
  }
}

PomonaRays pomona_rays(uint4 windings) {
  PomonaRays rays;
  rays.fraction = float4(2.0, 2.0, 2.0, 2.0);
  rays.on_a = rays.on_b = float4(0.0, 0.0, 0.0, 0.0);
  rays.side = uint4(0u, 0u, 0u, 0u);
  rays.winding = float4(windings & 3u) - 1.0;
  return rays;
}

// `g`: the point in cells of the grid, (point - origin) / spacing. False in air. `part`: which part of the fruit it is.
bool pomona_look(float3 g, out float3 color, out int part) {
  color = float3(0.0, 0.0, 0.0);
  part = -1;
  if (any(g < 0.0) || any(g >= pomona_count - 1.0)) return false;
  int3 cell = int3(g);
  float3 within = g - float3(cell);
  uint2 entry = pomona_cell.Load(int4(cell, 0));
  uint count = entry.y & 4095u;
  if (count == 0u) {
    // No surface is near: all corners are seen.
    if (((entry.y >> 12) & 3u) == 1u) return false;
    color = pomona_grid.SampleLevel(pomona_linear, (g + 0.5) / pomona_count, 0.0).rgb;
    part = int(pomona_grid.Load(int4(cell, 0)).a * 255.0 + 0.5) - 1;
    return true;
  }

  // Look towards the corners, and for the nearest place of all.
  float4 x = float4(-within.x, 1.0 - within.x, -within.x, 1.0 - within.x);
  float4 y = float4(-within.y, -within.y, 1.0 - within.y, 1.0 - within.y);
  float2 z = float2(-within.z, 1.0 - within.z);
  uint w = entry.y;
  PomonaRays low = pomona_rays(uint4(w >> 12, w >> 14, w >> 16, w >> 18));
  PomonaRays high = pomona_rays(uint4(w >> 20, w >> 22, w >> 24, w >> 26));
  float nearest = 1e9;
  float3 nearest_place = float3(0.0, 0.0, 0.0), nearest_weight = float3(0.0, 0.0, 0.0);
  uint nearest_side = 0u;
  int3 base = cell * pomona_units;
  float unit = 1.0 / float(pomona_units);
  float reach = 1.0 + 1.5 * unit;  // rounding may have put a corner behind a surface that was behind it
  [loop] for (uint i = entry.x; i < entry.x + count; ++i) {
    uint number = pomona_list.Load(int3(int(i & 2047u), int(i >> 11), 0));
    uint4 t = pomona_texel(number, 0u), u = pomona_texel(number, 1u);
    float3 a = (float3(int3(int(t.x & 65535u), int(t.x >> 16), int(t.y & 65535u)) - base) + 0.5) * unit - within;
    float3 b = (float3(int3(int(t.y >> 16), int(t.z & 65535u), int(t.z >> 16)) - base) + 0.5) * unit - within;
    float3 c = (float3(int3(int(t.w & 65535u), int(t.w >> 16), int(u.x & 65535u)) - base) + 0.5) * unit - within;
    float3 edge_a = cross(b, c), edge_b = cross(c, a), edge_c = cross(a, b);
    float volume = dot(a, edge_a);
    uint hidden = (u.x >> 16) & 3u, side = 2u * number + (volume < 0.0 ? 0u : 1u);
    float step_over = hidden == 0u ? 0.0 : ((volume < 0.0) == (hidden == 1u) ? -1.0 : 1.0);
    pomona_meet(low, x, y, z.x, edge_a, edge_b, edge_c, volume, side, step_over, reach);
    pomona_meet(high, x, y, z.y, edge_a, edge_b, edge_c, volume, side, step_over, reach);

    float3 weight = pomona_nearest(a, b, c), place = weight.x * a + weight.y * b + weight.z * c;
    float squared = dot(place, place);
    if (squared < nearest) {
      bool front = volume <= 0.0;
      nearest = squared;
      nearest_place = place;
      nearest_weight = weight;
      nearest_side = 2u * number + (front ? 0u : 1u);
      part = int((front ? u.y : u.y >> 16) & 65535u);
    }
  }
  if (abs(dot(low.winding + high.winding, float4(1.0, 1.0, 1.0, 1.0))) < 4.0) return false;

  // Fit what they see.
  PomonaFit fit;
  fit.one = float4(0.0, 0.0, 0.0, 0.0);
  fit.diagonal = fit.beside = fit.value = fit.by_x = fit.by_y = fit.by_z = float3(0.0, 0.0, 0.0);
  pomona_add(fit, nearest_place, pomona_side(nearest_side, nearest_weight));
  [unroll] for (int k = 0; k < 8; ++k) {
    bool upper = k >= 4;
    int i = k & 3;
    float3 towards = float3(x[i], y[i], upper ? z.y : z.x);
    float fraction = upper ? high.fraction[i] : low.fraction[i];
    if (fraction < 2.0) {
      float2 on = upper ? float2(high.on_a[i], high.on_b[i]) : float2(low.on_a[i], low.on_b[i]);
      uint side = upper ? high.side[i] : low.side[i];
      pomona_add(fit, fraction * towards, pomona_side(side, float3(on, 1.0 - on.x - on.y)));
    } else {
      float4 value = pomona_grid.Load(int4(cell + int3(k & 1, (k >> 1) & 1, k >> 2), 0));
      if (value.a > 0.0) pomona_add(fit, towards, value.rgb);
    }
  }
  color = clamp(pomona_value(fit), pomona_low, pomona_high);
  return true;
}
