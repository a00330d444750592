// Point clouds: a LAS as fast as its bytes, a LAZ on one core, an octree made and opened.

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/site/clouds/octree/cloud_octree.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/clouds/point_writer.h"
#include "tests/support/places.h"

namespace {

using namespace rubble;

/// A wavy site of 200 m as a LAS 1.4 in a temporary folder.
class MadeSite {
public:
    explicit MadeSite(std::uint64_t points)
        : m_folder((std::filesystem::temp_directory_path() / ("rubble-bench-cloud-" + std::to_string(::getpid()))).string()) {
        std::filesystem::create_directory(m_folder);
        io::WrittenCloud cloud;
        cloud.points = points;
        cloud.box = Aabb(Vec3(0.0, 0.0, 0.0), Vec3(200.0, 200.0, 20.0));
        const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(points))));
        io::writePoints(path(), cloud, [&](std::size_t k, io::WrittenPoint& point) {
            const std::uint64_t column = k % side;
            const std::uint64_t row = k / side;
            const double x = 200.0 * static_cast<double>(column) / static_cast<double>(side);
            const double y = 200.0 * static_cast<double>(row) / static_cast<double>(side);
            point.place = {x, y, 10.0 + 5.0 * std::sin(x / 9.0) * std::cos(y / 7.0) + 1e-3 * static_cast<double>(k * 7919 % 97)};
        });
    }
    ~MadeSite() {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    MadeSite(const MadeSite&) = delete;
    MadeSite& operator=(const MadeSite&) = delete;

    std::string path() const { return m_folder + "/site.las"; }

private:
    std::string m_folder;
};

/// Reads a cloud to its end; opening it, which looks its system up, is not measured.
std::uint64_t readWhole(benchmark::State& state, const std::string& path, int threads) {
    state.PauseTiming();
    const std::unique_ptr<io::PointCloud> cloud = io::openCloud(path);
    io::CloudBlock block;
    std::uint64_t points = 0;
    state.ResumeTiming();
    while (cloud->next(block, Execution().withThreads(threads))) {
        points += block.size();
        benchmark::DoNotOptimize(block.places.data());
    }
    return points;
}

void countPoints(benchmark::State& state, std::uint64_t points, std::uint64_t bytes) {
    using benchmark::Counter;
    state.counters["points"] = static_cast<double>(points);
    state.counters["Mpoints_s"] = Counter(static_cast<double>(points) / 1e6, Counter::kIsIterationInvariantRate);
    state.counters["MB_s"] = Counter(static_cast<double>(bytes) / 1e6, Counter::kIsIterationInvariantRate);
}

void readCloudBytes(benchmark::State& state) {
    const MadeSite site(10'000'000);
    std::vector<char> buffer(std::size_t{1} << 20);
    for (auto _ : state) {
        std::ifstream file(site.path(), std::ios::binary);
        while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || file.gcount() > 0) {
            benchmark::DoNotOptimize(buffer.data());
        }
    }
    countPoints(state, 10'000'000, std::filesystem::file_size(site.path()));
}
BENCHMARK(readCloudBytes)->Name("cloud, LAS, bytes alone")->Unit(benchmark::kMillisecond)->UseRealTime();

void readLas(benchmark::State& state) {
    const MadeSite site(10'000'000);
    std::uint64_t points = 0;
    for (auto _ : state) {
        points = readWhole(state, site.path(), static_cast<int>(state.range(0)));
    }
    countPoints(state, points, std::filesystem::file_size(site.path()));
}
BENCHMARK(readLas)->Name("cloud, LAS, by threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

// Real terrain with colours and times, format 3, 50,000 points a chunk.
void readLaz(benchmark::State& state) {
    const std::string path = sourcePath("tests/data/clouds/autzen_trim.laz");
    std::uint64_t points = 0;
    for (auto _ : state) {
        points = readWhole(state, path, static_cast<int>(state.range(0)));
    }
    countPoints(state, points, std::filesystem::file_size(path));
}
BENCHMARK(readLaz)->Name("cloud, LAZ of format 3, by threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

double peakMegabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// Made once, then opened as a second session does, with a tenth of its nodes read.
void makeOctree(benchmark::State& state) {
    const auto points = static_cast<std::uint64_t>(state.range(0)) * 1'000'000;
    const MadeSite site(points);
    double opened = 0.0;
    for (auto _ : state) {
        state.PauseTiming();
        std::filesystem::remove(site.path() + io::octreeEnding);
        state.ResumeTiming();
        const io::OpenedOctree made = io::openOctree(site.path(), {}, Execution());
        state.PauseTiming();
        const auto begun = std::chrono::steady_clock::now();
        const io::OpenedOctree again = io::openOctree(site.path(), {}, Execution());
        for (std::size_t node = 0; node < again.octree->nodes().size(); node += 10) {
            benchmark::DoNotOptimize(again.octree->read(node));
        }
        opened = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        if (!made.made || again.made) {
            state.SkipWithError("the octree was not made once");
        }
        state.ResumeTiming();
    }
    countPoints(state, points, std::filesystem::file_size(site.path()));
    state.counters["again_s"] = opened;
    state.counters["memory_MB"] = peakMegabytes();
}
BENCHMARK(makeOctree)
    ->Name("octree of so many million points")
    ->Arg(10)
    ->Arg(50)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

}  // namespace
