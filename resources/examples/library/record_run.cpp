// record_run FE RUN.h5: reads an FE result, simulates it and records the run, then reads the run back.

#include <core/base/build.h>
#include <core/base/error.h>
#include <core/pipeline/pipeline.h>
#include <core/scenario/parameters.h>
#include <io/fe/fe_reader.h>
#include <io/run/run_file.h>

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: record_run FE RUN.h5\n");
        return 2;
    }
    try {
        const rubble::Execution execution([](const rubble::Progress& progress) {
            std::fprintf(stderr, "\r%-30s %3.0f %%", rubble::englishText(progress.stage).c_str(), 100.0 * progress.fraction);
        });
        rubble::io::RunOrigin origin;
        rubble::setParameterText(origin.scenario, "settle_time", "1");
        rubble::Inputs inputs;
        inputs.fe = rubble::io::openFe(argv[1], origin.scenario.import, inputs.frame, execution);
        inputs.frame = inputs.fe->contents().frame;
        origin.fePath = argv[1];
        origin.feSha256 = inputs.fe->contents().sha256;
        origin.frame = inputs.frame;
        origin.scenarioName = "example";
        origin.build = rubble::buildText();
        origin.fingerprint = rubble::stageKey(inputs, origin.scenario, rubble::Stage::Simulation);
        {
            const auto sink = rubble::io::createRun(argv[2], origin);
            rubble::run(inputs, origin.scenario, rubble::Stage::Simulation, {}, sink.get(), execution);
        }
        const auto run = rubble::io::openRun(argv[2]);
        std::printf("%zu frames, %zu fragments, trajectory %s\n", run->frameCount(), run->fragments()->size(),
                    run->result()->trajectoryHash.hex().c_str());
    } catch (const rubble::Error& error) {
        std::fprintf(stderr, "\n%s\n  %s\n", rubble::englishText(error.message()).c_str(),
                     rubble::englishText(error.remedy()).c_str());
        return 1;
    }
    return 0;
}
