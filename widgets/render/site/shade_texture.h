#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

#include "widgets/render/basics/colours.h"
#include "widgets/render/site/ground_shade.h"

class vtkImageData;
class vtkPolyData;
class vtkTexture;

namespace rubble::render {

/// The light on the ground as a texture: what a surface is multiplied with, or a black veil over it.
class ShadeTexture {
public:
    enum class Kind : std::uint8_t {
        Light,  ///< opaque: the light, with the quiet unevenness of ground
        Veil    ///< black, as thick as the shade is deep
    };
    explicit ShadeTexture(Kind kind);
    ~ShadeTexture();

    vtkTexture* texture() const;
    /// Follows a shade; costs nothing while that has not changed.
    void follow(const GroundShade& shade, const SceneColours& colours);
    /// Gives the points of a surface their places in the texture of a shade.
    static void lay(vtkPolyData& surface, const GroundShade& shade);

private:
    void makeTexture(const GroundShade& shade);

    Kind m_kind;
    vtkSmartPointer<vtkImageData> m_image;
    vtkSmartPointer<vtkTexture> m_texture;
    std::vector<float> m_uneven;  ///< by cell, 0 to 1
    const GroundShade* m_followed = nullptr;
    std::uint64_t m_version = 0;
    double m_depth = -1.0;
    double m_roughness = -1.0;
};

}  // namespace rubble::render
