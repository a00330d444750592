#pragma once

#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/pipeline/pipeline.h"
#include "core/scenario/case.h"
#include "io/exports/provenance.h"
#include "io/exports/report_facts.h"
#include "io/run/run_file.h"
#include "widgets/render/basics/scene_data.h"

namespace rubble {

/// Everything that a page of a run is made of, as it was when it was asked for.
struct PageOrder {
    std::string path;
    std::shared_ptr<io::RunReader> run;
    Inputs inputs;
    Case theCase;
    std::string casePath;  ///< empty: it was not saved
    std::string basePath;  ///< that the inputs of the case are relative to
    render::SceneData scene;
    std::vector<io::ShownFile> around;
    Findings site{};  ///< of terrain and what stands around

    /// Writes it, on the worker. Throws what io::exportPage() throws, and what drawing throws.
    void write(const Execution& execution) const;
};

/// Everything that a report of a run is made of, as it was when it was asked for.
struct ReportOrder {
    io::ReportRequest request;  ///< without the case
    std::vector<io::ShownFile> around;
    Case theCase;
    QString selfTest;  ///< "all", "closed-form", "none"
    render::SceneData scene;
    std::string folder;

    /// What it says but the self-test. Throws as io::reportFacts().
    ReportFacts facts(const Execution& execution) const;
    /// Writes it, on the worker, and returns what it lacks. Throws what the facts, drawing and writing throw.
    Findings write(const Execution& execution) const;
};

}  // namespace rubble
