// Readers of the VTK family and of Exodus II beside VTK's own, and beside plain reading of the same bytes: what the disk, or the
// machine's memory of it, gives at best. Ratios hold within one run.

#include <benchmark/benchmark.h>
#include <hdf5.h>
#include <vtkExodusIIReader.h>
#include <vtkNew.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "io/fe/exodus/exodus_reader.h"
#include "io/fe/fe_reader.h"
#include "io/fe/vtk/vtk_reader.h"
#include "tests/support/places.h"

namespace {

using namespace rubble;

const std::string fixtures = buildPath("tests/fe/");

/// A result, and how ours and VTK's reader read it.
struct Subject {
    std::string path;
    FeResult::Contents (*ours)(const std::string& path, const ImportSettings& settings, const Execution& execution);
    std::function<void(const std::string& file)> vtk;  ///< reads all states of one file
};

template <class Reader>
void readWhole(const std::string& file) {
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    if constexpr (requires { reader->ReadAllFieldsOn(); }) {
        reader->ReadAllScalarsOn();
        reader->ReadAllVectorsOn();
        reader->ReadAllFieldsOn();
    }
    reader->Update();
}

// The deaths are a variable of elements; VTK has to be told to read it, at every step. Attributes that it asks for and does not
// find would be told at length, which takes longer than reading.
void readExodusByVtk(const std::string& file) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    vtkNew<vtkExodusIIReader> reader;
    reader->SetFileName(file.c_str());
    reader->UpdateInformation();
    reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
    for (int k = 0; k < reader->GetNumberOfTimeSteps(); ++k) {
        reader->SetTimeStep(k);
        reader->Update();
    }
}

Subject flagged() {
    return {fixtures + "vtu-status/series.pvd", io::readVtk, readWhole<vtkXMLUnstructuredGridReader>};
}
Subject legacy() {
    return {fixtures + "vtk-legacy-anim_to_vtk/PROJ_001.vtk", io::readVtk, readWhole<vtkUnstructuredGridReader>};
}
Subject exodus() {
    return {sourcePath("resources/samples/stone-arch.exo"), io::readExodus, readExodusByVtk};
}

// Files of states: an index file among them is text that takes no time.
std::vector<std::string> gridsOf(const Subject& subject) {
    std::vector<std::string> files = io::feFiles(subject.path);
    std::erase_if(files, [](const std::string& file) { return file.ends_with(".pvd") || file.ends_with(".series"); });
    return files;
}

std::int64_t bytesOf(const std::vector<std::string>& files) {
    std::int64_t bytes = 0;
    for (const std::string& file : files) {
        bytes += static_cast<std::int64_t>(std::filesystem::file_size(file));
    }
    return bytes;
}

void readBytes(benchmark::State& state, Subject (*make)()) {
    const std::vector<std::string> files = gridsOf(make());
    std::vector<char> buffer(std::size_t{1} << 20);
    for (auto _ : state) {
        for (const std::string& file : files) {
            std::ifstream in(file, std::ios::binary);
            while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
                benchmark::DoNotOptimize(buffer.data());
            }
        }
    }
    state.SetBytesProcessed(state.iterations() * bytesOf(files));
}

void indexResult(benchmark::State& state, Subject (*make)()) {
    const Subject subject = make();
    for (auto _ : state) {
        benchmark::DoNotOptimize(subject.ours(subject.path, {}, Execution{}));
    }
    state.SetBytesProcessed(state.iterations() * bytesOf(gridsOf(subject)));
}

void indexByVtk(benchmark::State& state, Subject (*make)()) {
    const Subject subject = make();
    const std::vector<std::string> files = gridsOf(subject);
    for (auto _ : state) {
        for (const std::string& file : files) {
            subject.vtk(file);
        }
    }
    state.SetBytesProcessed(state.iterations() * bytesOf(files));
}

// Any state without the others.
void readState(benchmark::State& state, Subject (*make)()) {
    const Subject subject = make();
    const FeResult::Contents contents = subject.ours(subject.path, {}, Execution{});
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(contents.source->read((k += 7) % contents.times.size()));
    }
}

BENCHMARK_CAPTURE(readBytes, vtu, flagged)->Name("VTU, 16 states, all deaths: bytes alone")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(indexResult, vtu, flagged)->Name("VTU, 16 states, all deaths: ours")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(indexByVtk, vtu, flagged)->Name("VTU, 16 states, all deaths: VTK's reader")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readState, vtu, flagged)->Name("VTU, 16 states, one state: ours")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readBytes, legacy, legacy)->Name("legacy VTK, 16 states, all deaths: bytes alone")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(indexResult, legacy, legacy)->Name("legacy VTK, 16 states, all deaths: ours")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(indexByVtk, legacy, legacy)
    ->Name("legacy VTK, 16 states, all deaths: VTK's reader")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readState, legacy, legacy)->Name("legacy VTK, 16 states, one state: ours")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readBytes, exodus, exodus)->Name("Exodus, 24 MB, all deaths: bytes alone")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(indexResult, exodus, exodus)->Name("Exodus, 24 MB, all deaths: ours")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(indexByVtk, exodus, exodus)->Name("Exodus, 24 MB, all deaths: VTK's reader")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readState, exodus, exodus)->Name("Exodus, 24 MB, one state: ours")->Unit(benchmark::kMillisecond);

}  // namespace
