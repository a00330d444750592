#pragma once

/// Parts of the shaders that give surfaces the grain of their material: three octaves of value noise over the place at rest (xyz,
/// m), as strong as the fourth number says; and that darken points by what the model leaves of their light.
namespace rubble::render::grain_shader {

inline constexpr const char* vertexDeclaration = R"(//VTK::Color::Dec
in vec4 grainMC;
in float shadeMC;
out vec4 grainVS;
out float shadeVS;
)";

inline constexpr const char* vertex = R"(//VTK::Color::Impl
grainVS = grainMC;
shadeVS = shadeMC;
)";

inline constexpr const char* fragmentDeclaration = R"(//VTK::Color::Dec
in vec4 grainVS;
in float shadeVS;
float grainHash(vec3 p) {
  p = fract(p * 0.3183099 + vec3(0.11, 0.23, 0.37));
  p *= 17.0;
  return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}
float grainNoise(vec3 x) {
  vec3 i = floor(x);
  vec3 f = fract(x);
  f = f * f * (3.0 - 2.0 * f);
  vec4 low = vec4(grainHash(i), grainHash(i + vec3(1, 0, 0)), grainHash(i + vec3(0, 1, 0)), grainHash(i + vec3(1, 1, 0)));
  vec4 high = vec4(grainHash(i + vec3(0, 0, 1)), grainHash(i + vec3(1, 0, 1)), grainHash(i + vec3(0, 1, 1)), grainHash(i + vec3(1, 1, 1)));
  vec4 z = mix(low, high, f.z);
  vec2 y = mix(z.xy, z.zw, f.y);
  return mix(y.x, y.y, f.x);
}
)";

inline constexpr const char* fragment = R"(//VTK::Color::Impl
{
  float coarse = grainNoise(grainVS.xyz * 0.9);
  float fine = grainNoise(grainVS.xyz * 5.3);
  float tone = 1.0 + grainVS.w * (0.42 * (coarse - 0.5) + 0.34 * (fine - 0.5));
  // A shadow takes the light of the sun; of what comes from everywhere only hollows take a part.
  ambientColor *= tone * (1.0 - 0.5 * shadeVS);
  diffuseColor *= tone * (1.0 - shadeVS);
}
)";

}  // namespace rubble::render::grain_shader
