#include "core/engine/soft/sleeping_contacts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rubble {
namespace {

SoftContact contactOf(std::uint32_t a, std::uint32_t b, std::uint32_t part) {
    SoftContact contact;
    contact.pair = colliderPair(a, b);
    contact.part = part;
    return contact;
}

std::vector<ColliderPair> pairsOf(const SleepingContacts& contacts, std::uint32_t number) {
    std::vector<ColliderPair> pairs;
    contacts.forEachPairOf(number, [&](const SoftContact& c) { pairs.push_back(c.pair); });
    return pairs;
}

SleepingContacts someContacts() {
    SleepingContacts contacts;
    for (const SoftContact& contact : {contactOf(3, 7, 0), contactOf(3, 7, 2), contactOf(1, 3, 0), contactOf(7, 9, 5)}) {
        contacts.put(contact);
    }
    return contacts;
}

TEST(SleepingContacts, AreFoundByEitherOfThePair) {
    const SleepingContacts contacts = someContacts();
    EXPECT_EQ(pairsOf(contacts, 3), (std::vector{colliderPair(1, 3), colliderPair(3, 7)}));
    EXPECT_EQ(pairsOf(contacts, 7), (std::vector{colliderPair(3, 7), colliderPair(7, 9)}));
    EXPECT_TRUE(pairsOf(contacts, 2).empty());
    ASSERT_NE(contacts.of(colliderPair(7, 3)), nullptr);
    EXPECT_EQ(contacts.of(colliderPair(7, 3))->size(), 2u);
    EXPECT_EQ(contacts.of(colliderPair(1, 7)), nullptr);
}

TEST(SleepingContacts, LeaveOneByOneAndAllTogether) {
    SleepingContacts contacts = someContacts();
    contacts.remove(colliderPair(3, 7), 0);
    contacts.remove(colliderPair(3, 7), 1);  // there is none
    EXPECT_EQ(contacts.of(colliderPair(3, 7))->front().part, 2u);
    contacts.remove(colliderPair(3, 7), 2);
    EXPECT_EQ(contacts.of(colliderPair(3, 7)), nullptr);
    EXPECT_EQ(pairsOf(contacts, 7), std::vector{colliderPair(7, 9)});
    contacts.removeIf([](const SoftContact& c) { return c.part == 5; });
    EXPECT_TRUE(pairsOf(contacts, 9).empty());
    EXPECT_FALSE(contacts.empty());
    contacts.removeIf([](const SoftContact&) { return true; });
    EXPECT_TRUE(contacts.empty());
}

TEST(SleepingContacts, AreTheSameAfterTheyWereKept) {
    const auto keepContacts = [](Archive& archive, std::vector<SoftContact>& kept) { archive(kept); };
    SleepingContacts contacts = someContacts();
    Archive out;
    contacts.keep(out, keepContacts);
    const std::string bytes = std::move(out).take();
    Archive in(bytes);
    SleepingContacts again;
    again.keep(in, keepContacts);
    EXPECT_TRUE(in.atEnd());
    for (const std::uint32_t number : {1u, 3u, 7u, 9u}) {
        EXPECT_EQ(pairsOf(again, number), pairsOf(contacts, number)) << number;
    }
}

}  // namespace
}  // namespace rubble
