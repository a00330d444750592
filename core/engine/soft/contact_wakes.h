#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/soft/sleeping_contacts.h"
#include "core/engine/soft/soft_bodies.h"
#include "core/engine/world/sleep.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

/// Frozen bodies that the contacts of this step wake: struck hard, or on a piece that moves. What lies on a body that is lifted is
/// lifted in the same instant, since as long as it sleeps it is a wall above the piece. In order, each once.
/// @param parts  contacts as found
std::vector<std::uint32_t> wokenByContacts(std::span<const std::vector<FoundContact>> parts, const SoftBodies& bodies,
                                           const Sleep& sleep, const SleepingContacts& asleep, WorkerPool& pool);

}  // namespace rubble
