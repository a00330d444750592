#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "io/site/clouds/octree/cloud_bulk.h"
#include "io/site/clouds/octree/cloud_octree.h"
#include "io/site/clouds/octree/octree_choice.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/io/site/clouds/forged_octree.h"

using namespace rubble;

namespace {

/// Reads all nodes of an octree; what is taken is finite, and a view keeps its budget.
void readAll(const io::CloudOctree& octree) {
    std::uint64_t left = 200'000;  // rows may name the same bytes again and again
    for (std::size_t n = 0; n < octree.nodes().size(); ++n) {
        const io::OctreeNode& node = octree.nodes()[n];
        if (!(node.spacing > 0.0) || (node.parent && *node.parent >= n) || !node.box.min().allFinite() ||
            !node.box.max().allFinite()) {
            __builtin_trap();
        }
        if (node.points > left) {
            continue;
        }
        left -= node.points;
        const io::CloudBlock block = octree.read(n);
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (!block.places[i].allFinite() || (!block.intensity.empty() && !std::isfinite(block.intensity[i]))) {
                __builtin_trap();
            }
        }
    }
    const io::OctreeChoice choice = io::chooseNodes(octree.nodes(), [](std::size_t n) { return n % 7 == 6 ? 0.0 : 2.0; }, 1000);
    if (choice.points > 1000 || octree.levels() < 1 || !(octree.placeStep() > 0.0)) {
        __builtin_trap();
    }
}

/// Makes the octree of a cloud that has any numbers as coordinates: each point lies in it once.
void makeOne(const std::uint8_t* bytes, std::size_t size) {
    constexpr std::size_t pointBytes = 3 * sizeof(double);
    const std::size_t points = size / pointBytes;
    std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points) +
                      "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    ply.append(reinterpret_cast<const char*>(bytes), points * pointBytes);
    const std::string path = layDown(ply.data(), ply.size(), "made.ply");
    const io::OpenedOctree opened = io::openOctree(path, {}, fuzzExecution());
    readAll(*opened.octree);
    std::uint64_t sum = 0;
    for (const io::OctreeNode& node : opened.octree->nodes()) {
        sum += node.points;
    }
    if (opened.summary && sum != opened.summary->points()) {
        __builtin_trap();
    }
}

}  // namespace

/// Reads any bytes as an octree with marks and digests that fit, as the note of a digest beside one, or as the points of a cloud
/// that gets one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        if (size > 0 && bytes[0] == 'P') {
            makeOne(bytes + 1, size - 1);
        } else if (size > 0 && bytes[0] == 'N') {
            const std::string octree = (fuzzFolder() / "noted.octree").string();
            const std::string cloud = layDown("1 2 3\n", 6, "noted");
            const std::string stamp =
                std::to_string(io::stampOf(cloud).bytes) + ' ' + std::to_string(io::stampOf(cloud).time) + ' ';
            const std::string note = stamp + std::string(reinterpret_cast<const char*>(bytes + 1), size - 1);
            layDown(note.data(), note.size(), "noted.octree.checked");
            io::rememberedDigest(cloud, octree, fuzzExecution());
        } else {
            std::string file(reinterpret_cast<const char*>(bytes), size);
            io::putOctreeRight(file);
            readAll(io::CloudOctree(layDown(file.data(), file.size(), "any.octree")));
        }
    } catch (const Error&) {
    }
    return 0;
}
