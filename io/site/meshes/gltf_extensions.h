#pragma once

#include <string_view>

namespace rubble::io {

/// What an extension of glTF means for the shape of a model.
enum class GltfExtension {
    Looks,    ///< changes colours, light or words only: what is read does not depend on it
    Read,     ///< changes the shape, and is read
    Unknown,  ///< may change the shape
};
GltfExtension gltfExtension(std::string_view name);

}  // namespace rubble::io
