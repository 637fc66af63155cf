// Colours, as in generator/base/color.cpp: linear RGB, OKLab [Ottosson 2020], the sRGB curve.

vec3 cube_root(vec3 v) { return sign(v) * pow(abs(v), vec3(1.0 / 3.0)); }

vec3 to_oklab(vec3 c) {
  vec3 lms = cube_root(vec3(dot(vec3(0.4122214708, 0.5363325363, 0.0514459929), c),
                            dot(vec3(0.2119034982, 0.6806995451, 0.1073969566), c),
                            dot(vec3(0.0883024619, 0.2817188376, 0.6299787005), c)));
  return vec3(dot(vec3(0.2104542553, 0.7936177850, -0.0040720468), lms),
              dot(vec3(1.9779984951, -2.4285922050, 0.4505937099), lms),
              dot(vec3(0.0259040371, 0.7827717662, -0.8086757660), lms));
}

vec3 from_oklab(vec3 lab) {
  vec3 lms = vec3(dot(vec3(1.0, 0.3963377774, 0.2158037573), lab), dot(vec3(1.0, -0.1055613458, -0.0638541728), lab),
                  dot(vec3(1.0, -0.0894841775, -1.2914855480), lab));
  vec3 cubed = lms * lms * lms;
  return vec3(dot(vec3(4.0767416621, -3.3077115913, 0.2309699292), cubed),
              dot(vec3(-1.2684380046, 2.6097574011, -0.3413193965), cubed),
              dot(vec3(-0.0041960863, -0.7034186147, 1.7076147010), cubed));
}

vec3 srgb_from_linear(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
