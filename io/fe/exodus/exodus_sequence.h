#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/scenario/scenario.h"
#include "io/fe/exodus/exodus_file.h"
#include "io/fe/exodus/exodus_mesh.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/series/mesh_series.h"

namespace rubble::io {

/// A sequence of Exodus files as one series: elements that a file leaves out are dead, and those that its flag calls dead.
class ExodusSequence : public MeshSeries {
public:
    /// Opens every file once. Throws as ExodusFile does.
    ExodusSequence(std::vector<std::string> files, const ImportSettings& settings);

    /// True where the first file has no elements, as that of a processor that had nothing to do.
    bool empty() const;
    SeriesStep step(std::size_t k) override;
    SeriesFields fields(std::size_t k) const override;

private:
    struct State {
        std::size_t file = 0;
        std::size_t state = 0;  ///< in that file
    };

    std::shared_ptr<const ExodusFile> file(std::size_t f) const;
    void dropUnfinished();
    void addStates(std::size_t f, const ExodusFile& file);

    std::vector<std::string> m_files;
    ImportSettings m_settings;
    std::vector<State> m_states;
    ExodusMesh m_mesh;  ///< of the newest step's file
    mutable std::mutex m_mutex;
    mutable std::list<std::pair<std::size_t, std::shared_ptr<const ExodusFile>>> m_open;  ///< most recently used first
};

}  // namespace rubble::io
