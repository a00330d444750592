#include "core/simulation/run/sealed_checkpoint.h"

#include <algorithm>

#include "core/base/build.h"
#include "core/base/resumable_hash.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

constexpr std::array<char, 16> magicWord{'r', 'u', 'b', 'b', 'l', 'e', '-', 'c', 'h', 'e', 'c', 'k', 'p', 'o', 'i', 'n'};
constexpr std::uint32_t formatVersion = 1;

/// What stands before the content.
struct Head {
    std::array<char, 16> magic = magicWord;
    std::uint32_t version = formatVersion;
    Digest run;
    Digest content;

    void keep(Archive& archive) { archive(magic, version, run.bytes, content.bytes); }
};
constexpr std::size_t headSize = sizeof magicWord + sizeof formatVersion + 2 * sizeof(Digest::bytes);

Digest digestOf(std::string_view bytes) {
    return Hasher().bytes(bytes.data(), bytes.size()).finish();
}

void addPlace(Hasher& hasher, const Vec3& place) {
    hasher.bytes(place.data(), 3 * sizeof(double));
}

}  // namespace

Digest runDigest(const RunDescription& description) {
    Hasher hasher;
    hasher.text("run").text(buildText()).value(ResumableHasher::stateVersion()).digest(description.fingerprint);
    for (int stage = 0; stage < stageCount; ++stage) {
        hasher.digest(scenarioSlice(description.scenario, static_cast<Stage>(stage)));
    }
    hasher.values(std::span<const double>(description.fe->times()));
    // A repeat of a study keeps the clusters of its base, which no scenario says.
    hasher.value(static_cast<std::uint64_t>(description.fragments->size()));
    for (const Fragment& fragment : description.fragments->list) {
        hasher.value(fragment.element).value(fragment.birthTime).value(fragment.mass);
        addPlace(hasher, fragment.centre);
        addPlace(hasher, fragment.velocity);
    }
    hasher.values(std::span<const FragmentId>(description.clustering->members));
    for (const Cluster& cluster : description.clustering->list) {
        hasher.value(cluster.memberCount).value(cluster.handOverState).value(cluster.mass);
        addPlace(hasher, cluster.centre);
    }
    return hasher.finish();
}

void beginCheckpoint(Archive& archive, const Digest& run) {
    Head head;
    head.run = run;
    archive(head);
}

std::string sealCheckpoint(Archive&& archive) {
    std::string bytes = std::move(archive).take();
    const Digest content = digestOf(std::string_view(bytes).substr(headSize));
    std::copy(content.bytes.begin(), content.bytes.end(), bytes.begin() + headSize - content.bytes.size());
    return bytes;
}

std::optional<std::string_view> openCheckpoint(std::string_view bytes, const Digest& run, Findings& findings) {
    const auto damaged = [&](std::string_view what) {
        addDamagedCheckpoint(findings, what);
        return std::nullopt;
    };
    if (bytes.size() < headSize) {
        return damaged("it is shorter than its head");
    }
    Head head;
    Archive archive(bytes);
    archive(head);
    if (head.magic != magicWord) {
        return damaged("it does not begin as one");
    }
    if (head.version != formatVersion || head.run != run) {
        findings.add({"simulation.checkpoint_foreign",
                      "A checkpoint is of another build, input or setting: the simulation begins at its start.",
                      {}},
                     {"simulation.checkpoint_foreign.remedy", "Nothing needs doing: the next checkpoint takes its place.", {}});
        return std::nullopt;
    }
    const std::string_view content = bytes.substr(headSize);
    if (digestOf(content) != head.content) {
        return damaged("its bytes are not those that were written");
    }
    return content;
}

std::optional<std::string> latestCheckpoint(CheckpointStore* checkpoints, Findings& findings) {
    try {
        return checkpoints != nullptr ? checkpoints->latest() : std::nullopt;
    } catch (const WorldError& error) {
        addDamagedCheckpoint(findings, error.what());
        return std::nullopt;
    }
}

void addDamagedCheckpoint(Findings& findings, std::string_view example) {
    findings.add(
        {"simulation.checkpoint_damaged", "A checkpoint is damaged: the simulation begins at its start.", {}},
        {"simulation.checkpoint_damaged.remedy", "Nothing needs doing: the next checkpoint takes its place. Check the disk.", {}},
        example);
}

}  // namespace rubble
