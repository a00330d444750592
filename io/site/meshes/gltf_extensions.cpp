#include "io/site/meshes/gltf_extensions.h"

#include <algorithm>
#include <array>

namespace rubble::io {

GltfExtension gltfExtension(std::string_view name) {
    // All of KHR_materials_ are about looks.
    static constexpr std::array<std::string_view, 18> looks{
        "KHR_texture_transform",   "KHR_texture_basisu",   "KHR_lights_punctual", "KHR_xmp",
        "KHR_xmp_json_ld",         "KHR_techniques_webgl", "EXT_texture_webp",    "EXT_texture_avif",
        "EXT_lights_image_based",  "EXT_lights_ies",       "EXT_mesh_features",   "EXT_instance_features",
        "EXT_structural_metadata", "EXT_feature_metadata", "MSFT_texture_dds",    "CESIUM_primitive_outline",
        "CESIUM_tile_edges",       "KHR_animation_pointer"};
    if (name == "KHR_mesh_quantization") {
        return GltfExtension::Read;
    }
    const bool about = name.starts_with("KHR_materials_") || std::find(looks.begin(), looks.end(), name) != looks.end();
    return about ? GltfExtension::Looks : GltfExtension::Unknown;
}

}  // namespace rubble::io
