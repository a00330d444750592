#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/evidence/cautions.h"
#include "core/evidence/ensembles/ensemble.h"
#include "core/scenario/case.h"
#include "io/case/open_case.h"

namespace rubble::io {

/// What an ensemble stands on, for its files.
struct EnsembleInput {
    std::string role;  ///< "fe", "terrain", "evidence"
    std::string path;
    std::string sha256;
};

/// What an ensemble, or a comparison of several, was made from.
struct EnsembleBasis {
    /// What members were simulated by, but for what was varied.
    struct Scene {
        std::string name;  ///< of the case and of its scenario
        Scenario scenario;
    };
    std::vector<EnsembleInput> inputs;
    Frame frame;
    Site site;
    std::vector<Caution> cautions;  ///< inputCautions() of all of its inputs
    std::vector<Scene> scenes{};

    /// Takes in what one more cause stands on; it lies in the frame of the first.
    void join(const EnsembleBasis& other);
};

/// A case with all that the members of its ensemble stand on.
struct EnsembleSource {
    std::string name;  ///< of the case, of its scenario where one was asked for, or of the file if the case has none
    Case theCase;      ///< as openCase() gives it
    std::vector<EnsembleScene> scenes;
    std::vector<EnsembleInput> inputs;
    std::string fePath;              ///< of the first scene, absolute
    std::vector<std::string> files;  ///< everything that was read: never written over
    Frame frame;
    CloudRequest terrainRead;       ///< of a terrain that is a point cloud
    Findings findings;              ///< of what was read
    std::vector<Caution> cautions;  ///< of the same

    EnsembleBasis basis() const;
};

/// Ids or names of the scenarios that members are drawn from, each once; empty: the scenario is not varied.
std::vector<std::string> variedScenarios(const EnsembleSettings& settings);

/// Opens the scenarios of a case that its ensemble draws from; the one alone that is named, or if scenarios are not varied the one
/// that is worked on. An FE result is opened as an ensemble of one scenario.
/// Throws as openCase().
EnsembleSource openEnsemble(const CaseRequest& request, const EnsembleSettings& settings, const Execution& execution);

/// What one more cause is called: a name that is taken gets the FE result's file in brackets, and a number where that is taken too.
/// @param taken  names so far
std::string causeName(const std::string& name, const std::string& fePath, std::span<const std::string> taken);

/// The case that an FE result without one is simulated by as one more cause: a scenario of another case, with this result instead.
Case caseOfCause(const Case& like, const CaseScenario& scenario, const std::string& fePath);

/// Takes a case as one more cause of what happened at one site, under causeName(). Settings other than those of the first are told.
/// @param first  of the causes so far; null: this is the first. @param taken  names so far
/// Throws UsageError ("causes.other_frame") where frame or control points are others than those of the first.
void joinCauses(EnsembleSource& next, const EnsembleSource* first, std::span<const std::string> taken);

/// The terrain that evidence is held above, for EvidenceSite::groundFile; empty if there is none or surroundings raise it.
std::string evidenceGround(const EnsembleSource& source);

}  // namespace rubble::io
