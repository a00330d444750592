#pragma once

#include <cstddef>
#include <vector>

namespace rubble {

/// Lets the process keep freed memory of up to a quarter of a gigabyte instead of giving it back at once. Every step of a
/// simulation and every state read needs blocks of a few megabytes; taken from the system anew each time they come page by page
/// and zeroed: 6.5 % of the processors' time of a run of the stone arch. For the start of a program; a library leaves this to its
/// host.
void keepFreedMemory();

/// Lets the system give memory that nothing has touched yet in pages of two megabytes: it then comes 512 times less often, and is
/// found with fewer tables. Small pieces stay as they are. A hint; where the system takes none, nothing happens.
void takeLargePages(void* from, std::size_t bytes);

/// Room for so many items, in large pages: for what holds millions. Items that are there are moved.
template <class Item>
void reserveLarge(std::vector<Item>& items, std::size_t count) {
    if (count > items.capacity()) {
        items.reserve(count);
        takeLargePages(items.data(), items.capacity() * sizeof(Item));
    }
}

}  // namespace rubble
