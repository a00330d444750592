#include "tests/samples/arches.h"

#include "io/fe/fe_reader.h"
#include "tests/support/places.h"

namespace rubble::arches {

namespace {

Arch make(const std::string& name, const std::vector<RegroupStep>& steps) {
    Arch arch;
    const Execution execution;
    arch.fe = io::openFe(sourcePath("resources/samples/") + name, {}, {}, execution);
    arch.components = groupComponents(arch.fe->mesh(), steps, {}, {});
    // Each state by itself, as the independent script and the published method count them.
    FragmentSettings byState;
    byState.birthWindow = 0.0;
    arch.fragments = makeFragments(*arch.fe, arch.components, byState, execution);
    return arch;
}

}  // namespace

const Arch& stoneArch() {
    static const Arch arch = make("stone-arch.exo", {});
    return arch;
}

const Arch& rcArch() {
    static const Arch arch = make("rc-arch.exo", {});
    return arch;
}

const Arch& mergedStoneArch() {
    static const Arch arch =
        make("stone-arch.exo", {MergeComponents{{"arch ring 1", "arch ring 1, failing strip"}, "arch ring 1"},
                                MergeComponents{{"arch ring 4", "arch ring 4, failing strip"}, "arch ring 4"}});
    return arch;
}

}  // namespace rubble::arches
