#pragma once

namespace rubble {

/// Lets the process keep freed memory of up to a quarter of a gigabyte instead of giving it back at once. Every step of a
/// simulation and every state read needs blocks of a few megabytes; taken from the system anew each time they come page by page
/// and zeroed: 6.5 % of the processors' time of a run of the stone arch. For the start of a program; a library leaves this to its
/// host.
void keepFreedMemory();

}  // namespace rubble
