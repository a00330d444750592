// Readers of FE results: the real projectile of tests/data beside VTK's own reader, and a generated d3plot family of the 20 GB
// class (sparse: places and stresses are holes, the deletion tables are written), indexed, scrubbed and held against the cap of
// memory.

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vtkLSDynaReader.h>
#include <vtkNew.h>

#include <array>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "io/fe/d3plot/d3plot_reader.h"
#include "io/fe/fe_reader.h"
#include "tests/support/places.h"

namespace {

using namespace rubble;

const std::string projectile = buildPath("tests/fe/projectile/d3plot");

/// A family of bricks in a temporary folder, 4-byte little-endian, a state a file.
class SparseFamily {
public:
    static constexpr std::int64_t bricks = 100000, nodes = 110000, values = 100, states = 480;

    SparseFamily() : m_folder((std::filesystem::temp_directory_path() / ("rubble-bench-" + std::to_string(::getpid()))).string()) {
        std::filesystem::create_directory(m_folder);
        writeRoot();
        for (std::int64_t k = 0; k < states; ++k) {
            writeState(k);
        }
    }
    ~SparseFamily() {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    SparseFamily(const SparseFamily&) = delete;
    SparseFamily& operator=(const SparseFamily&) = delete;

    std::string root() const { return m_folder + "/d3plot"; }

private:
    static void put(std::ofstream& file, const std::vector<std::int32_t>& words) {
        file.write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(words.size() * sizeof words[0]));
    }

    void writeRoot() const {
        std::ofstream file(root(), std::ios::binary);
        std::vector<std::int32_t> head(64, 0);
        for (const auto& [word, value] : {std::pair{11, 1}, {15, 4}, {17, 6}, {20, 1}, {21, 1}, {24, 1}, {36, -10002}, {51, 1}}) {
            head[static_cast<std::size_t>(word)] = value;
        }
        head[16] = nodes;
        head[23] = bricks;
        head[27] = values;
        put(file, head);
        std::vector<float> places;
        for (std::int64_t n = 0; n < nodes; ++n) {
            const std::int64_t row = n / 100 % 100, column = n % 100, layer = n / 10000;
            places.insert(places.end(), {static_cast<float>(row), static_cast<float>(column), static_cast<float>(layer)});
        }
        file.write(reinterpret_cast<const char*>(places.data()), static_cast<std::streamsize>(places.size() * sizeof(float)));
        std::vector<std::int32_t> rows;
        for (std::int32_t e = 0; e < bricks; ++e) {
            const std::int32_t n = e % 9800 + 1;
            rows.insert(rows.end(), {n, n + 100, n + 101, n + 1, n + 10000, n + 10100, n + 10101, n + 10001, 1});
        }
        put(file, rows);
        put(file, {std::bit_cast<std::int32_t>(-999999.0f)});
    }

    void writeState(std::int64_t k) const {
        char number[16];
        std::snprintf(number, sizeof number, "%02d", static_cast<int>(k + 1));
        std::ofstream file(root() + number, std::ios::binary);
        put(file, {std::bit_cast<std::int32_t>(0.01f * static_cast<float>(k + 1))});
        file.seekp(4 * (1 + 6 * nodes + values * bricks));
        std::vector<std::int32_t> alive(bricks, std::bit_cast<std::int32_t>(1.0f));
        std::fill_n(alive.begin(), bricks * k / states / 2, 0);
        put(file, alive);
        put(file, {std::bit_cast<std::int32_t>(-999999.0f)});
    }

    std::string m_folder;
};

double residentMegabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void indexProjectile(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(io::readD3plot(projectile, {}, Execution{}));
    }
    state.SetBytesProcessed(state.iterations() *
                            static_cast<std::int64_t>(io::openFe(projectile, {}, {}, Execution{})->contents().bytes));
}
BENCHMARK(indexProjectile)->Name("d3plot, 5 states, all deaths: ours")->Unit(benchmark::kMillisecond);

// The same bytes read and thrown away: what the disk, or the machine's memory of it, gives at best.
void readProjectileBytes(benchmark::State& state) {
    const std::vector<std::string> files = io::feFiles(projectile);
    std::vector<char> buffer(std::size_t{1} << 20);
    std::int64_t bytes = 0;
    for (auto _ : state) {
        for (const std::string& name : files) {
            std::ifstream file(name, std::ios::binary);
            while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0) {
                bytes += file.gcount();
                benchmark::DoNotOptimize(buffer.data());
            }
        }
    }
    state.SetBytesProcessed(bytes);
}
BENCHMARK(readProjectileBytes)->Name("d3plot, 5 states, all deaths: bytes alone")->Unit(benchmark::kMillisecond);

void readProjectileState(benchmark::State& state) {
    const FeResult::Contents contents = io::readD3plot(projectile, {}, Execution{});
    std::size_t k = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(contents.source->read(k++ % contents.times.size()));
    }
}
BENCHMARK(readProjectileState)->Name("d3plot, 5 states, one state: ours")->Unit(benchmark::kMillisecond);

// VTK's reader has to read every state to know the deaths.
void indexProjectileByVtk(benchmark::State& state) {
    for (auto _ : state) {
        vtkNew<vtkLSDynaReader> reader;
        reader->SetFileName(projectile.c_str());
        reader->UpdateInformation();
        for (vtkIdType k = 0; k < reader->GetNumberOfTimeSteps(); ++k) {
            reader->SetTimeStep(k);
            reader->Update();
        }
    }
}
BENCHMARK(indexProjectileByVtk)->Name("d3plot, 5 states, all deaths: VTK's reader")->Unit(benchmark::kMillisecond);

void readProjectileStateByVtk(benchmark::State& state) {
    vtkNew<vtkLSDynaReader> reader;
    reader->SetFileName(projectile.c_str());
    reader->UpdateInformation();
    vtkIdType k = 0;
    for (auto _ : state) {
        reader->SetTimeStep(k++ % reader->GetNumberOfTimeSteps());
        reader->Update();
    }
}
BENCHMARK(readProjectileStateByVtk)->Name("d3plot, 5 states, one state: VTK's reader")->Unit(benchmark::kMillisecond);

// Index once, then states at random places; memory before and after.
void scrubTwentyGigabytes(benchmark::State& state) {
    const SparseFamily family;
    const double before = residentMegabytes();
    const auto begun = std::chrono::steady_clock::now();
    auto contents = io::readD3plot(family.root(), {}, Execution{});
    const double index = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    contents.format = "LS-DYNA d3plot";
    const FeResult fe(std::move(contents));
    std::uint64_t bytes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(family.root()).parent_path())) {
        bytes += entry.file_size();
    }
    std::mt19937 random(1);
    for (auto _ : state) {
        benchmark::DoNotOptimize(fe.state(random() % fe.stateCount()));
    }
    state.counters["index_s"] = index;
    state.counters["gigabytes"] = static_cast<double>(bytes) / 1e9;
    state.counters["memory_MB"] = residentMegabytes() - before;
}
BENCHMARK(scrubTwentyGigabytes)->Name("d3plot family of 20 GB, states at random")->Unit(benchmark::kMillisecond)->Iterations(500);

}  // namespace
