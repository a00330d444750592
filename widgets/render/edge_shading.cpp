#include "widgets/render/edge_shading.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

namespace rubble::render {
namespace {

constexpr const char* vertexShader = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec2 tcoordMC;
out vec2 tcoordVC;
void main() {
  tcoordVC = tcoordMC;
  gl_Position = vertexMC;
}
)";

/// Takes the place of VTK's shader that lays the two shades over the colours; names of the three textures are its own.
constexpr const char* fragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 tcoordVC;
uniform sampler2D s2_S1;  // shade in full resolution, and the depth
uniform sampler2D s2_S2;  // shade in low resolution
uniform sampler2D s2_C;
uniform vec2 clipping;  // near and far
uniform vec2 fading;    // from and to
uniform int parallel;

float distanceAt(float depth) {
  if (parallel != 0) {
    return mix(clipping.x, clipping.y, depth);
  }
  return clipping.x * clipping.y / mix(clipping.y, clipping.x, depth);
}

void main() {
  vec4 fine = texture2D(s2_S1, tcoordVC);
  // What is shaded by an edge fades with the edge, so that the model keeps its outline before a far ground.
  float nearest = fine.a;
  vec2 pixel = 1.0 / vec2(textureSize(s2_S1, 0));
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      nearest = min(nearest, texture2D(s2_S1, tcoordVC + vec2(x, y) * pixel).a);
    }
  }
  float shade = mix(fine.r, texture2D(s2_S2, tcoordVC).r, 0.3);
  float faded = smoothstep(fading.x, fading.y, distanceAt(nearest));
  vec4 colour = texture2D(s2_C, tcoordVC);
  gl_FragData[0] = vec4(colour.rgb * mix(shade, 1.0, faded), colour.a);
  gl_FragDepth = fine.a;
}
)";

}  // namespace

EdgeShading* EdgeShading::New() {
    VTK_STANDARD_NEW_BODY(EdgeShading);
}

void EdgeShading::setFading(double from, double to) {
    m_from = from;
    m_to = to;
}

void EdgeShading::Render(const vtkRenderState* state) {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
    vtkOpenGLShaderCache* shaders = window->GetShaderCache();
    // A program that is there already is not made by VTK.
    if (EDLComposeProgram.Program == nullptr) {
        EDLComposeProgram.Program = shaders->ReadyShaderProgram(vertexShader, fragmentShader, "");
    } else {
        shaders->ReadyShaderProgram(EDLComposeProgram.Program);
    }
    if (vtkShaderProgram* program = EDLComposeProgram.Program) {
        vtkCamera* camera = state->GetRenderer()->GetActiveCamera();
        const double* range = camera->GetClippingRange();
        const float clipping[2] = {static_cast<float>(range[0]), static_cast<float>(range[1])};
        const float fading[2] = {static_cast<float>(m_from), static_cast<float>(m_to)};
        program->SetUniform2f("clipping", clipping);
        program->SetUniform2f("fading", fading);
        program->SetUniformi("parallel", camera->GetParallelProjection());
    }
    Superclass::Render(state);
}

}  // namespace rubble::render
