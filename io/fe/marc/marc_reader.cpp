#include "io/fe/marc/marc_reader.h"

#include <algorithm>
#include <memory>
#include <unordered_map>

#include "io/fe/marc/marc_file.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

class MarcSeries : public MeshSeries {
public:
    explicit MarcSeries(const std::string& path) : m_file(path) {
        m_facts.findings = m_file.findings();
        bool stress = !m_file.increments().empty();
        for (std::size_t k = 0; k < m_file.increments().size(); ++k) {
            const MarcIncrement& increment = m_file.increments()[k];
            m_facts.times.push_back(increment.time);
            m_rewritten = m_rewritten || (k > 0 && increment.mesh);
            m_facts.hasVelocity = m_facts.hasVelocity || increment.velocity.has_value();
            stress = stress && !increment.stressed.empty();
        }
        m_byStress = stress && !m_rewritten && deathListBeside(path).empty();
        if (m_byStress) {
            findStress();
            m_facts.flag.name = "stress";
            m_facts.flag.activeByName = 1;
            m_facts.findings.add(
                {"marc.inferred",
                 "The file does not say which elements are dead: those whose stress falls to exactly zero for good were taken",
                 {}},
                {"marc.inferred.remedy",
                 "Elements that never carry stress are taken for dead as well. Let UACTIVE take them off the post file (mode -1), "
                 "or put a "
                 "list of deaths (element,time) beside it.",
                 {}},
                path);
        }
    }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        const MarcIncrement& increment = m_file.increments()[k];
        if (increment.mesh) {
            Mesh mesh = m_file.readMesh(*increment.mesh, m_facts.findings);
            m_places = mesh.nodes;
            m_whole = mesh.elementCount() == increment.stressed.size();
            step.mesh = std::move(mesh);
        }
        const bool same = !m_reference.empty() && (!increment.mesh || *m_reference.back() == m_places);
        m_reference.push_back(same ? m_reference.back() : std::make_shared<const std::vector<Vec3>>(m_places));
        if (m_byStress && m_whole) {
            step.flags = flags(k);
        }
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        const MarcIncrement& increment = m_file.increments()[k];
        SeriesFields fields;
        fields.positions = *m_reference[k];
        const std::size_t nodes = fields.positions.size();
        if (increment.displacement) {
            const std::vector<Vec3> moved = m_file.readVectors(*increment.displacement, nodes);
            for (std::size_t n = 0; n < nodes; ++n) {
                fields.positions[n] += moved[n];
            }
        }
        if (increment.velocity) {
            fields.velocities = m_file.readVectors(*increment.velocity, nodes);
        }
        return fields;
    }

private:
    // Dead: no stress from here to the end, after some. What never carries any while most others do died before its first state of
    // stress.
    std::vector<double> flags(std::size_t k) const {
        std::vector<double> result(m_firstStress.size(), 1.0);
        for (std::size_t e = 0; e < result.size(); ++e) {
            const bool ever = m_firstStress[e] < times().size();
            result[e] = (ever ? m_lastStress[e] < k : k >= m_firstLoaded) ? 0.0 : 1.0;
        }
        return result;
    }

    void findStress() {
        const auto& increments = m_file.increments();
        m_firstStress.assign(increments.front().stressed.size(), increments.size());
        m_lastStress.assign(m_firstStress.size(), 0);
        m_firstLoaded = increments.size();
        for (std::size_t k = 0; k < increments.size(); ++k) {
            const std::vector<bool>& now = increments[k].stressed;
            const auto loaded = static_cast<std::size_t>(std::count(now.begin(), now.end(), true));
            if (2 * loaded > now.size()) {
                m_firstLoaded = std::min(m_firstLoaded, k);
            }
            for (std::size_t e = 0; e < std::min(m_firstStress.size(), increments[k].stressed.size()); ++e) {
                if (increments[k].stressed[e]) {
                    m_firstStress[e] = std::min(m_firstStress[e], k);
                    m_lastStress[e] = k;
                }
            }
        }
    }

    MarcFile m_file;
    bool m_rewritten = false, m_byStress = false, m_whole = false;
    std::vector<Vec3> m_places;                                         // of the newest mesh
    std::vector<std::shared_ptr<const std::vector<Vec3>>> m_reference;  // places at rest of each state's nodes
    std::vector<std::size_t> m_firstStress, m_lastStress;               // state [elements]
    std::size_t m_firstLoaded = 0;                                      // first state at which most elements carry stress
};

}  // namespace

bool recognisesMarc(const FileHead& head) {
    return !head.packed && head.bytes.starts_with("=beg=5");
}

FeResult::Contents readMarc(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    return readSeries(path, std::make_shared<MarcSeries>(path), settings, execution);
}

}  // namespace rubble::io
