#pragma once

#include <memory>
#include <vector>

#include "core/fe/fe_result.h"
#include "io/fe/series/mesh_series.h"

namespace rubble::io {

/// The meshes of an adaptive run as one series. Each family has a mesh of its own; a later one counts from its first state on. An
/// element that was refined stays, and is active as long as one of the elements that took its place is; these are no elements of
/// their own. Elements that a later mesh leaves out otherwise are dead.
class AdaptiveSeries : public MeshSeries {
public:
    /// @param families  as they were read one by one, in their order; none empty
    explicit AdaptiveSeries(std::vector<FeResult::Contents> families);

    SeriesStep step(std::size_t k) override;
    SeriesFields fields(std::size_t k) const override;

    /// Whether nodes can be told apart by their numbers; those of particles cannot.
    static bool joinable(const std::vector<FeResult::Contents>& families);

private:
    /// A mesh with refined elements in place of those that took theirs.
    struct Level {
        Mesh mesh;
        std::vector<std::vector<std::uint32_t>> sources;  ///< elements of the family that stand for each element of the mesh
    };
    struct State {
        std::size_t family = 0, state = 0;
    };

    void refine(std::size_t family, const Level& before);

    std::vector<FeResult::Contents> m_families;
    std::vector<State> m_states;
    Level m_level;  ///< of the newest step
};

}  // namespace rubble::io
