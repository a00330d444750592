#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/activity.h"
#include "core/fe/mesh.h"
#include "io/fe/series/mesh_union.h"

namespace rubble::io {

/// Names of parts whose elements are dead, as the user writes them: by name or number, between semicolons or commas.
std::vector<std::string> deadPartNames(const std::string& setting);

/// Which part each element of a series belongs to from state to state. Elements are dead while they are in a part that the user
/// names; without the user's word, while they are in one named dead, inactive or the like into which they have moved.
class PartMembership {
public:
    /// @param setting  see deadPartNames(); empty: by the names of parts
    explicit PartMembership(const std::string& setting) : m_wanted(deadPartNames(setting)) {}

    /// Takes the mesh of a state after it was joined. @param united  the union it was joined to  @param state  named in the finding
    void add(const Mesh& mesh, const MeshUnion& united, std::size_t state);
    /// Whether the part of an element of the union is one of the dead, at the newest mesh.
    bool dead(std::size_t element) const { return element < m_dead.size() && m_dead[element]; }
    /// How deadness by parts was decided, for people; empty where no element was dead by its part.
    std::string decidedBy() const;
    /// Counts elements that change their part. Throws UsageError for wanted names that no part has; lists those there are.
    void note(Findings& findings, const std::string& path) const;

private:
    bool isDead(const Part& part, bool moved);

    std::vector<std::string> m_wanted;
    std::vector<std::string> m_known;  ///< names of all parts met
    std::vector<std::size_t> m_first;  ///< place among the known of each element's first part
    std::vector<bool> m_dead, m_moved;
    std::vector<bool> m_found;          ///< [wanted]
    std::vector<std::string> m_byName;  ///< parts taken for dead by their names
    std::int64_t m_changed = 0;
    std::string m_example;
};

/// The same for a result whose elements keep their part: those of the named parts are dead at every state. Throws UsageError.
void killParts(const std::string& setting, const Mesh& mesh, Activity& activity, std::string& activityFrom,
               const std::string& path);

}  // namespace rubble::io
