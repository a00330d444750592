#include "app/cli/fe/missing_facts.h"

#include <cmath>

namespace rubble::cli {

std::vector<MissingFact> missingFacts(const FeResult& fe) {
    std::int64_t density = 0, thickness = 0, section = 0;
    const Mesh& mesh = fe.mesh();
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        density += std::isnan(mesh.density[e]);
        if (std::isnan(mesh.section[e]) && !isSolid(mesh.shapes[e])) {
            ++(isShell(mesh.shapes[e]) ? thickness : section);
        }
    }
    std::vector<MissingFact> facts;
    const auto note = [&](bool missing, const char* what, std::int64_t count, const char* instead) {
        if (missing) {
            facts.push_back({what, count, instead});
        }
    };
    note(density > 0, "density", density, "assumed; say it with --set component[NAME].density");
    note(thickness > 0, "thickness", thickness, "assumed; say it with --set component[NAME].section");
    note(section > 0, "section", section, "assumed; say it with --set component[NAME].section");
    note(!fe.contents().hasVelocity, "velocity", 0, "taken from differences of positions");
    note(fe.contents().deathTime.empty(), "death_time", 0, "known to one interval of states");
    note(!fe.contents().declared, "units", 0, "by the frame of the case (kg, m, s unless set); say them with --set units");
    return facts;
}

}  // namespace rubble::cli
