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

/// What the shader of fragments declares. The noise and the tone are those of resources/shaders/grain.glsl, which pages of runs
/// have as well.
const char* fragmentDeclaration();

inline constexpr const char* fragment = R"(//VTK::Color::Impl
{
  float tone = grainTone(grainVS.xyz, grainVS.w);
  // A shadow takes the light of the sun; of what comes from everywhere only hollows take a part.
  ambientColor *= tone * (1.0 - 0.5 * shadeVS);
  diffuseColor *= tone * (1.0 - shadeVS);
}
)";

}  // namespace rubble::render::grain_shader
