#include "core/base/archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/resumable_hash.h"

namespace rubble {
namespace {

enum class Colour : std::uint8_t { Red, Blue };

struct Leaf {
    int number = 0;
    Vec3 place = Vec3::Zero();

    void keep(Archive& archive) { archive(number, place); }
};

/// Everything that an archive knows.
struct Tree {
    bool flag = false;
    double number = 0.0;
    Colour colour = Colour::Red;
    std::string text;
    Mat3 matrix = Mat3::Zero();
    Pose pose;
    OrientedBox box;
    Aabb bounds;
    std::vector<double> numbers;
    std::vector<bool> flags;
    std::vector<Leaf> leaves;
    std::vector<std::vector<char>> nested;
    std::array<Leaf, 2> pair;
    std::optional<Leaf> some, none;
    std::optional<Colour> chosen;
    std::map<Colour, Leaf> byColour;
};

void keep(Archive& archive, Tree& of) {
    archive(of.flag, of.number, of.colour, of.text, of.matrix, of.pose, of.box, of.bounds, of.numbers, of.flags, of.leaves,
            of.nested, of.pair, of.some, of.none, of.chosen, of.byColour);
}

Tree grown() {
    Tree tree;
    tree.flag = true;
    tree.number = -0.0;
    tree.colour = Colour::Blue;
    tree.text = std::string("zero \0 within", 13);
    tree.matrix << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    tree.pose = {Vec3(0.1, 0.2, 0.3), Quat(0.5, -0.5, 0.5, 0.5)};
    tree.box.halfExtents = Vec3(1, 2, 3);
    tree.bounds.extend(Vec3(-1, -2, -3));
    tree.numbers = {0.1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::denorm_min()};
    tree.flags = {true, false, true};
    tree.leaves = {{7, Vec3(1, 0, 0)}, {8, Vec3(0, 1, 0)}};
    tree.nested = {{'a'}, {}, {'b', 'c'}};
    tree.pair[1].number = 9;
    tree.some = Leaf{3, Vec3(4, 5, 6)};
    tree.chosen = Colour::Blue;
    tree.byColour[Colour::Red].number = 1;
    tree.byColour[Colour::Blue].number = 2;
    return tree;
}

std::string bytesOf(Tree tree) {
    Archive archive;
    archive(tree);
    return std::move(archive).take();
}

TEST(Archive, GivesBackEveryBit) {
    const std::string bytes = bytesOf(grown());
    // What was there before is gone.
    Tree tree;
    tree.numbers.resize(100, 1.0);
    tree.none = Leaf{};
    tree.byColour[Colour::Red].place = Vec3(1, 1, 1);
    Archive archive(bytes);
    archive(tree);
    EXPECT_TRUE(archive.atEnd());
    EXPECT_EQ(bytesOf(tree), bytes);
    EXPECT_TRUE(std::signbit(tree.number));
    EXPECT_EQ(tree.text.size(), 13u);
    EXPECT_EQ(tree.numbers, grown().numbers);
    EXPECT_EQ(tree.flags, grown().flags);
    EXPECT_EQ(tree.leaves.at(1).place, Vec3(0, 1, 0));
    EXPECT_FALSE(tree.none);
    EXPECT_EQ(tree.some->number, 3);
    EXPECT_EQ(tree.byColour.at(Colour::Blue).number, 2);
}

TEST(Archive, NeverReadsBeyondItsBytes) {
    const std::string bytes = bytesOf(grown());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Tree tree;
        Archive archive(std::string_view(bytes).substr(0, size));
        EXPECT_THROW(archive(tree), ParseError) << size;
    }
}

TEST(Archive, TakesNoMemoryForWhatIsNotThere) {
    Archive writing;
    writing.count(std::size_t{1} << 60);
    const std::string bytes = std::move(writing).take() + "abc";
    std::vector<double> numbers;
    std::vector<Leaf> leaves;
    std::string text;
    EXPECT_THROW(Archive{bytes}(numbers), ParseError);
    EXPECT_THROW(Archive{bytes}(leaves), ParseError);
    EXPECT_THROW(Archive{bytes}(text), ParseError);
}

TEST(ResumableHasher, IsTheOtherOneAndGoesOnElsewhere) {
    std::vector<char> content(3000);
    for (std::size_t i = 0; i < content.size(); ++i) {
        content[i] = static_cast<char>(31 * i);
    }
    // Within and beyond the blocks in which the hash takes its food.
    for (const std::size_t cut : {0u, 1u, 63u, 64u, 240u, 241u, 256u, 257u, 1024u, 1500u, 3000u}) {
        const Digest whole = Hasher().bytes(content.data(), content.size()).finish();
        std::string bytes;
        {
            ResumableHasher first;
            first.bytes(content.data(), cut);
            Archive archive;
            archive(first);
            bytes = std::move(archive).take();
            EXPECT_EQ(first.bytes(content.data() + cut, content.size() - cut).finish(), whole) << "it is not changed by it";
        }
        ResumableHasher second;
        second.value(7);
        Archive archive(bytes);
        archive(second);
        EXPECT_EQ(second.bytes(content.data() + cut, content.size() - cut).finish(), whole) << cut;
    }
}

}  // namespace
}  // namespace rubble
