#include "core/simulation/effects/fragment_contact.h"

namespace rubble {

void setUpFragmentContact(WorldSettings& world) {
    world.bodyContacts = true;
}

}  // namespace rubble
