#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

struct SolverContact;

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
