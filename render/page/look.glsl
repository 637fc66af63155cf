// The colour inside a fruit at any point, in GLSL ES 3.00 or any later GLSL: the answer of
// generator/diffusion/harmonic/field_sampler.h, from four textures that any engine can hold. docs/reference/asset.md
// tells how they are made from an asset. engines/translate_look.py translates this text into HLSL, WGSL and Godot's
// language.

// sRGB, alpha; linear filter. Colours at nodes; alpha: 1 + the part there, of 255; 0 in air.
uniform highp sampler3D pomona_grid;
// x: first entry of the list; y: how many (bits 0-11), 1 + windings of 8 corners (2 bits each).
uniform highp usampler3D pomona_cell;
// 2048 wide: triangles by cell.
uniform highp usampler2D pomona_list;
// 4 texels each, 1024 a row: corners, hidden side, parts; front colours; back colours.
uniform highp usampler2D pomona_triangle;
// Nodes along each axis.
uniform vec3 pomona_count;
// Units of positions per cell.
uniform int pomona_units;
// The minimum of all colours, linear.
uniform vec3 pomona_low;
// The maximum of all colours, linear.
uniform vec3 pomona_high;

// Weights of a triangle's corners at its point nearest to the origin [Ericson 2005, 5.1.5].
vec3 pomona_nearest(vec3 a, vec3 b, vec3 c) {
  vec3 ab = b - a, ac = c - a;
  float a1 = -dot(ab, a), a2 = -dot(ac, a);
  if (a1 <= 0.0 && a2 <= 0.0) return vec3(1.0, 0.0, 0.0);
  float b1 = -dot(ab, b), b2 = -dot(ac, b);
  if (b1 >= 0.0 && b2 <= b1) return vec3(0.0, 1.0, 0.0);
  float across_c = a1 * b2 - b1 * a2;
  if (across_c <= 0.0 && a1 >= 0.0 && b1 <= 0.0) {
    float w = a1 / (a1 - b1);
    return vec3(1.0 - w, w, 0.0);
  }
  float c1 = -dot(ab, c), c2 = -dot(ac, c);
  if (c2 >= 0.0 && c1 <= c2) return vec3(0.0, 0.0, 1.0);
  float across_b = c1 * a2 - a1 * c2;
  if (across_b <= 0.0 && a2 >= 0.0 && c2 <= 0.0) {
    float w = a2 / (a2 - c2);
    return vec3(1.0 - w, 0.0, w);
  }
  float across_a = b1 * c2 - c1 * b2;
  if (across_a <= 0.0 && b2 - b1 >= 0.0 && c1 - c2 >= 0.0) {
    float w = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return vec3(0.0, 1.0 - w, w);
  }
  float sum = across_a + across_b + across_c;
  return vec3(1.0 - across_b / sum - across_c / sum, across_b / sum, across_c / sum);
}

uvec4 pomona_texel(uint number, uint texel) {
  return texelFetch(pomona_triangle, ivec2(int((number & 1023u) * 4u + texel), int(number >> 10u)), 0);
}

// The square roots of a colour in ten bits each.
vec3 pomona_color(uint bits) {
  vec3 root = vec3(float(bits & 1023u), float((bits >> 10u) & 1023u), float((bits >> 20u) & 1023u)) / 1023.0;
  return root * root;
}

// `side`: 2 * triangle, + 1 for its back.
vec3 pomona_side(uint side, vec3 weight) {
  uvec4 corner = pomona_texel(side >> 1u, 2u + (side & 1u));
  return weight.x * pomona_color(corner.x) + weight.y * pomona_color(corner.y) + weight.z * pomona_color(corner.z);
}

// The sums of the normal equations for a linear function through values at places around the origin, by least squares
// with weights 1 / (d^2 + 1/1000)^2.
struct PomonaFit {
  vec4 one;       // of w, w p
  vec3 diagonal;  // of w x x, w y y, w z z
  vec3 beside;    // of w x y, w x z, w y z
  vec3 value;
  vec3 by_x;
  vec3 by_y;
  vec3 by_z;
};

void pomona_add(inout PomonaFit fit, vec3 place, vec3 value) {
  float d = dot(place, place) + 1e-3, w = 1.0 / (d * d);
  vec3 p = w * place;
  fit.one += vec4(w, p);
  fit.diagonal += p * place;
  fit.beside += p.xxy * place.yzz;
  fit.value += w * value;
  fit.by_x += p.x * value;
  fit.by_y += p.y * value;
  fit.by_z += p.z * value;
}

// The function's value at the origin: z, y and x are eliminated in turn. A small stiffness keeps undetermined slopes at
// 0.
vec3 pomona_value(PomonaFit fit) {
  float stiff = 1e-6 * fit.one.x;
  float xx = fit.diagonal.x + stiff, yy = fit.diagonal.y + stiff, zz = fit.diagonal.z + stiff;
  float xy = fit.beside.x, xz = fit.beside.y, yz = fit.beside.z;
  float o = fit.one.x, x = fit.one.y, y = fit.one.z, z = fit.one.w;
  vec3 v = fit.value, vx = fit.by_x, vy = fit.by_y;

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

// Rays to four corners of a cell with the same z: how far they reach, what they hit, and how the boundary that they
// cross changes the corners' windings.
struct PomonaRays {
  vec4 fraction;  // 2 without a hit
  vec4 on_a;      // weights of the corners at the hit
  vec4 on_b;
  uvec4 side;
  vec4 winding;
};

void pomona_meet(inout PomonaRays rays, vec4 x, vec4 y, float z, mat3 edge, float volume, uint side, float step_over,
                 float reach) {
  // A ray passes through the triangle if all edges turn the same way around it.
  vec4 a = x * edge[0].x + y * edge[0].y + z * edge[0].z;
  vec4 b = x * edge[1].x + y * edge[1].y + z * edge[1].z;
  vec4 c = x * edge[2].x + y * edge[2].y + z * edge[2].z;
  vec4 sum = a + b + c, fraction = volume / sum;
  vec4 least = min(a, min(b, c)), most = max(a, max(b, c));
  vec4 zero = vec4(0.0);
  vec4 meets = max(vec4(greaterThanEqual(least, zero)), vec4(lessThanEqual(most, zero))) *
               vec4(greaterThanEqual(fraction, zero));
  rays.winding += step_over * meets * vec4(lessThanEqual(fraction, vec4(1.0)));
  bvec4 nearer =
      bvec4(meets * vec4(lessThanEqual(fraction, vec4(reach))) * vec4(lessThan(fraction, rays.fraction)));
  if (!any(nearer)) return;
  rays.fraction = mix(rays.fraction, fraction, nearer);
  rays.on_a = mix(rays.on_a, a / sum, nearer);
  rays.on_b = mix(rays.on_b, b / sum, nearer);
  uvec4 now = uvec4(nearer);
  rays.side = rays.side * (1u - now) + side * now;
}

// `g`: the point in cells of the grid, (point - origin) / spacing. False in air. `part`: which part of the fruit it is.
bool pomona_look(vec3 g, out vec3 color, out int part) {
  color = vec3(0.0);
  part = -1;
  if (any(lessThan(g, vec3(0.0))) || any(greaterThanEqual(g, pomona_count - 1.0))) return false;
  ivec3 cell = ivec3(g);
  vec3 within = g - vec3(cell);
  uvec2 entry = texelFetch(pomona_cell, cell, 0).xy;
  uint count = entry.y & 4095u;
  if (count == 0u) {
    // No surface is near: all corners are visible.
    if (((entry.y >> 12u) & 3u) == 1u) return false;
    color = textureLod(pomona_grid, (g + 0.5) / pomona_count, 0.0).rgb;
    part = int(texelFetch(pomona_grid, cell, 0).a * 255.0 + 0.5) - 1;
    return true;
  }

  // Cast rays to the corners, and find the nearest point of all triangles.
  vec4 x = vec4(-within.x, 1.0 - within.x, -within.x, 1.0 - within.x);
  vec4 y = vec4(-within.y, -within.y, 1.0 - within.y, 1.0 - within.y);
  vec2 z = vec2(-within.z, 1.0 - within.z);
  uvec4 shift = uvec4(12u, 14u, 16u, 18u);
  uvec4 two_bits = uvec4(3u);
  vec4 none = vec4(0.0);
  PomonaRays low = PomonaRays(vec4(2.0), none, none, uvec4(0u), vec4((entry.yyyy >> shift) & two_bits) - 1.0);
  PomonaRays high = PomonaRays(vec4(2.0), none, none, uvec4(0u), vec4((entry.yyyy >> (shift + 8u)) & two_bits) - 1.0);
  float nearest = 1e9;
  vec3 nearest_place = vec3(0.0), nearest_weight = vec3(0.0);
  uint nearest_side = 0u;
  ivec3 base = cell * pomona_units;
  float unit = 1.0 / float(pomona_units);
  float reach = 1.0 + 1.5 * unit;  // rounding may have moved a corner behind a surface
  uint listed = entry.x;
  do {
    uint number = texelFetch(pomona_list, ivec2(int(listed & 2047u), int(listed >> 11u)), 0).x;
    uvec4 t = pomona_texel(number, 0u), u = pomona_texel(number, 1u);
    vec3 a = (vec3(ivec3(uvec3(t.x & 65535u, t.x >> 16u, t.y & 65535u)) - base) + 0.5) * unit - within;
    vec3 b = (vec3(ivec3(uvec3(t.y >> 16u, t.z & 65535u, t.z >> 16u)) - base) + 0.5) * unit - within;
    vec3 c = (vec3(ivec3(uvec3(t.w & 65535u, t.w >> 16u, u.x & 65535u)) - base) + 0.5) * unit - within;
    mat3 edge = mat3(cross(b, c), cross(c, a), cross(a, b));
    float volume = dot(a, edge[0]);
    uint hidden = (u.x >> 16u) & 3u, side = 2u * number + (volume < 0.0 ? 0u : 1u);
    float step_over = hidden == 0u ? 0.0 : ((volume < 0.0) == (hidden == 1u) ? -1.0 : 1.0);
    pomona_meet(low, x, y, z.x, edge, volume, side, step_over, reach);
    pomona_meet(high, x, y, z.y, edge, volume, side, step_over, reach);

    vec3 weight = pomona_nearest(a, b, c), place = weight.x * a + weight.y * b + weight.z * c;
    float squared = dot(place, place);
    if (squared < nearest) {
      bool front = volume <= 0.0;
      nearest = squared;
      nearest_place = place;
      nearest_weight = weight;
      nearest_side = 2u * number + (front ? 0u : 1u);
      part = int((front ? u.y : u.y >> 16u) & 65535u);
    }
  } while (++listed < entry.x + count);
  if (abs(dot(low.winding + high.winding, vec4(1.0))) < 4.0) return false;

  // Fit the colours found.
  vec3 zero = vec3(0.0);
  PomonaFit fit = PomonaFit(none, zero, zero, zero, zero, zero, zero);
  pomona_add(fit, nearest_place, pomona_side(nearest_side, nearest_weight));
  int k = 0;
  do {
    bool upper = k >= 4;
    int i = k & 3;
    vec3 towards = vec3(x[i], y[i], upper ? z.y : z.x);
    float fraction = upper ? high.fraction[i] : low.fraction[i];
    if (fraction < 2.0) {
      vec2 on = upper ? vec2(high.on_a[i], high.on_b[i]) : vec2(low.on_a[i], low.on_b[i]);
      uint side = upper ? high.side[i] : low.side[i];
      pomona_add(fit, fraction * towards, pomona_side(side, vec3(on, 1.0 - on.x - on.y)));
    } else {
      vec4 value = texelFetch(pomona_grid, cell + ivec3(k & 1, (k >> 1u) & 1, k >> 2u), 0);
      if (value.a > 0.0) pomona_add(fit, towards, value.rgb);
    }
  } while (++k < 8);
  color = clamp(pomona_value(fit), pomona_low, pomona_high);
  return true;
}
