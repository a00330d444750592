#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/fe/fe_result.h"
#include "tests/io/sample_run.h"

class vtkUnstructuredGrid;

namespace rubble::io {

/// One hexahedron per fragment, which dies when the fragment is born, and `survivors` that never do; states 0.1 s apart, each 0.5 m
/// lower than the one before. @param onRead  called with every state that is read
std::shared_ptr<const FeResult> makeFe(const SampleRun& run, std::size_t survivors, std::size_t states,
                                       std::function<void(std::size_t)> onRead = {});

/// A made-up run of 30 clusters over seven states and five survivors, without islands.
SampleRun runOverFe(std::uint32_t seed, std::size_t frames, std::shared_ptr<const FeResult>& fe);

/// Holds every fragment of a grid (cells whose fragment_id is not negative) and how many there are against what is worked out here
/// by another way, through 4x4 matrices.
void expectFragments(vtkUnstructuredGrid& grid, const SampleRun& run, const TrajectoryReader& trajectory, double time);

}  // namespace rubble::io
