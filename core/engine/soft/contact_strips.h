#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rubble {

struct SolverContact;

/// Contacts in groups within which no movable body occurs twice: the contacts of a group can be solved in any order, on any
/// number of threads, to the same bits. The last group may repeat bodies and is solved in order.
struct ContactColours {
    std::vector<std::uint32_t> order;  ///< contacts by group
    std::vector<std::uint32_t> first;  ///< [groups + 1] into order
    bool lastInOrder = false;          ///< the last group must be solved one by one
};
/// Puts contacts into groups, in the order given.
/// @param movable  only bodies below this one count
void colourContacts(std::span<const std::pair<std::uint32_t, std::uint32_t>> ends, std::size_t movable, ContactColours& colours);

/// Contacts by strips of the site: a thread that keeps to one strip has its bodies in its own cache, and waits for others only
/// where strips meet.
struct ContactStrips {
    std::size_t count = 1;
    std::vector<std::uint16_t> strip;  ///< [contacts]
    std::vector<char> border;          ///< [contacts] one of its bodies has contacts in another strip as well
};

/// Cuts the site across its longer side so that every strip has about as many contacts. Contacts whose place is no number go to the
/// first strip.
/// @param movable  bodies from this one on belong to no strip
/// @param count    strips, at least 1
/// @param loose    contacts from this one on must be solved one by one and go to the first strip
void cutIntoStrips(std::span<const SolverContact> contacts, std::size_t movable, std::size_t count, std::size_t loose,
                   ContactStrips& strips);

}  // namespace rubble
