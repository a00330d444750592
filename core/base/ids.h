#pragma once

#include <cstddef>
#include <cstdint>

namespace rubble {

/// Index of an element in Mesh order (not the user's element number, which is Mesh::elementIds).
enum class ElementIndex : std::uint32_t {};
/// Index of a component in Components::list.
enum class ComponentId : std::uint32_t {};
/// Index of a fragment in FragmentSet order: by birth state, then element order.
enum class FragmentId : std::uint32_t {};
/// Index of a cluster in Clustering order: by hand-over state, then first fragment.
enum class ClusterId : std::uint32_t {};
/// Index of a rigid body in the order it entered the engine.
enum class BodyId : std::uint32_t {};

/// The plain index behind an id, for subscripts.
template <class Id>
constexpr std::size_t at(Id id) {
    return static_cast<std::size_t>(id);
}

/// The id with the given plain index.
template <class Id>
constexpr Id idAt(std::size_t index) {
    return static_cast<Id>(static_cast<std::uint32_t>(index));
}

}  // namespace rubble
