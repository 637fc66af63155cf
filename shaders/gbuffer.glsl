// The data of a pixel that the passes of a scene share.

// An id: bits 0-10 tell surfaces and cut faces apart, bit 11 marks cut faces, bits 12-30 hold the instance's number
// from 1 (0: ground or nothing).
uint instance_of(uint id) { return (id >> 12) & 0x7ffffu; }
bool is_cut(uint id) { return (id & 0x800u) != 0u; }

// Every instance's texels (render/gl/scene_instances.h): ink and its width in samples; the hand's wavelength in metres,
// width of inner lines in samples, solid, opacity; three rows of the matrix from the scene to the fruit.
uniform samplerBuffer instances;
const int instance_texels = 5;

vec4 ink_of(uint instance) { return texelFetch(instances, instance_texels * int(instance - 1u)); }
vec4 pen_of(uint instance) { return texelFetch(instances, instance_texels * int(instance - 1u) + 1); }
vec3 in_fruit(uint instance, vec3 scene_point) {
  int row = instance_texels * int(instance - 1u) + 2;
  vec4 p = vec4(scene_point, 1.0);
  return vec3(dot(texelFetch(instances, row), p), dot(texelFetch(instances, row + 1), p),
              dot(texelFetch(instances, row + 2), p));
}

// Its columns: the scene's directions in the fruit.
mat3 turn_to_fruit(uint instance) {
  int row = instance_texels * int(instance - 1u) + 2;
  return transpose(mat3(texelFetch(instances, row).xyz, texelFetch(instances, row + 1).xyz,
                        texelFetch(instances, row + 2).xyz));
}

uniform vec2 depth_range;  // near, far

float distance_from_depth(float depth) {
  return depth_range.x * depth_range.y / (depth_range.y - depth * (depth_range.y - depth_range.x));
}

// A fixed number for each pixel, evenly distributed over neighbours [Jimenez 2014].
float interleaved(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

// Places evenly distributed over a disc [Vogel 1979]: each a golden angle after the previous one, at sqrt((i + 0.5) /
// count) of the radius. Each pixel turns them by its own angle; a product from one to the next replaces sine and
// cosine.
const mat2 golden_angle = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

float spiral_radius(int i, int count) { return sqrt((float(i) + 0.5) / float(count)); }

vec2 first_direction(vec2 pixel) {
  float angle = 6.2831853 * interleaved(pixel);
  return vec2(cos(angle), sin(angle));
}
