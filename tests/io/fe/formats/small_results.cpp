#include "tests/io/fe/formats/small_results.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <vector>

namespace rubble::io {

namespace {

constexpr int nodes = 12;
constexpr std::array<std::array<int, 8>, 2> bricks{{{1, 2, 5, 4, 7, 8, 11, 10}, {2, 3, 6, 5, 8, 9, 12, 11}}};

std::array<double, 3> place(int node) {
    const int n = node - 1;
    return {static_cast<double>(n % 3), static_cast<double>(n / 3 % 2), static_cast<double>(n / 6)};
}

__attribute__((format(printf, 1, 2))) std::string print(const char* pattern, ...) {
    std::array<char, 512> buffer{};
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
    va_end(arguments);
    return buffer.data();
}

/// Words of a result file of Ansys.
class RstText {
public:
    std::size_t words() const { return m_bytes.size() / 4; }
    const std::string& get() const { return m_bytes; }

    // A record: its length, flags, values and an end. @return where it begins, words
    std::size_t integers(const std::vector<std::int32_t>& values) { return record(values.data(), values.size(), 0x80); }
    std::size_t reals(const std::vector<double>& values) { return record(values.data(), 2 * values.size(), 0); }

    void set(std::size_t begin, std::size_t at, std::initializer_list<std::size_t> values) {
        for (const std::size_t value : values) {
            const auto word = static_cast<std::int32_t>(value);
            std::memcpy(m_bytes.data() + 4 * (begin + 2 + at++), &word, 4);
        }
    }

private:
    std::size_t record(const void* bytes, std::size_t count, std::uint32_t flags) {
        const std::size_t begin = words();
        const std::uint32_t head[2] = {static_cast<std::uint32_t>(count), flags << 24};
        m_bytes.append(reinterpret_cast<const char*>(head), sizeof head);
        m_bytes.append(static_cast<const char*>(bytes), 4 * count);
        m_bytes.append(4, '\0');
        return begin;
    }

    std::string m_bytes;
};

std::string item(int value) {
    const std::string digits = std::to_string(value);
    return print("I%2zu", digits.size()) + digits;
}

std::string item(double value) {
    std::string text = print("%22.15E", value);
    text[text.find('E')] = 'D';
    return "D" + text;
}

std::string item(const std::string& text) {
    return "A" + print("%-8.8s", text.c_str());
}

std::string record(int key, const std::vector<std::string>& items) {
    std::string text = "*" + item(static_cast<int>(items.size()) + 2) + item(key);
    for (const std::string& one : items) {
        text += one;
    }
    return text;
}

std::string increment(int state, bool status) {
    std::vector<std::string> head{
        item(double(state)), item(double(state)), item(0.0), item(0.0), item(17), item(1), item(state), item(0),
        item(0.0),           item(0.0),           item(1.0)};
    head.resize(21, item(std::string("")));
    std::string text = record(2000, head);
    for (int e = 1; e <= 2; ++e) {
        text += record(1, {item(e), item(1), item(1), item(0), item(std::string("")), item(3), item(3), item(3), item(0)});
        text += status ? record(61, {item(state == 2 && e == 2 ? 0.0 : 1.0)}) : std::string();
    }
    for (int n = 1; n <= nodes; ++n) {
        text += record(101, {item(n), item(0.1 * state), item(0.0), item(0.0)});
    }
    text += record(2001, {});
    text.resize((text.size() + 79) / 80 * 80, ' ');
    return text;
}

std::string inLines(std::string text) {
    text.resize((text.size() + 79) / 80 * 80, ' ');
    std::string lines;
    for (std::size_t at = 0; at < text.size(); at += 80) {
        lines += text.substr(at, 80) + "\n";
    }
    return lines;
}

std::string marcMesh(int elements) {
    std::string text = "=beg=50200 (Analysis Verification Data)\n" +
                       print("%13d%13d%13d%13d%13d%13d\n", 1, nodes, elements, 3, 1, 9) +
                       print("%13d%13d%13d%13d%13d%13d\n", 1, 0, 3, 8, 2, 0) + print("%13d%13d\n=end=\n", 0, 12);
    text += "=beg=50600 (Element Variable Postcodes)\n" + print("%13d%24s\n=end=\n", 17, "von Mises");
    text += "=beg=50700 (Element Connectivities)\n";
    for (int e = 0; e < elements; ++e) {
        const auto& b = bricks[static_cast<std::size_t>(e)];
        text += print("%13d%13d%13d%13d%13d%13d\n", e + 1, 7, 8, b[0], b[1], b[2]);
        text += print("%13d%13d%13d%13d%13d\n", b[3], b[4], b[5], b[6], b[7]);
    }
    text += "=end=\n=beg=50800 (Nodal Coordinates)\n";
    for (int n = 1; n <= nodes; ++n) {
        const auto x = place(n);
        text += print("%13d%13.6E%13.6E%13.6E\n", n, x[0], x[1], x[2]);
    }
    return text + "=end=\n";
}

}  // namespace

std::string smallFil(bool status) {
    std::string model = record(1921, {item(std::string("6.14-1")), item(std::string("01-Jan-2")), item(std::string("026")),
                                      item(std::string("00:00:00")), item(2), item(nodes), item(1.0)});
    for (int e = 0; e < 2; ++e) {
        std::vector<std::string> items{item(e + 1), item(std::string("C3D8R"))};
        for (const int node : bricks[static_cast<std::size_t>(e)]) {
            items.push_back(item(node));
        }
        model += record(1900, items);
    }
    for (int n = 1; n <= nodes; ++n) {
        const auto x = place(n);
        model += record(1901, {item(n), item(x[0]), item(x[1]), item(x[2])});
    }
    model += record(1933, {item(std::string("WALL")), item(1), item(2)});
    model.resize((model.size() + 79) / 80 * 80, ' ');
    return inLines(model + increment(0, status) + increment(1, status) + increment(2, status));
}

std::string smallFrd() {
    std::string text = "    1C\n    1UUSER\n" + print("    2C%18s%12d%37s%1d\n", "", nodes, "", 1);
    for (int n = 1; n <= nodes; ++n) {
        const auto x = place(n);
        text += print(" -1%10d%12.5E%12.5E%12.5E\n", n, x[0], x[1], x[2]);
    }
    text += " -3\n" + print("    3C%18s%12d%37s%1d\n", "", 2, "", 1);
    for (int e = 0; e < 2; ++e) {
        const auto& b = bricks[static_cast<std::size_t>(e)];
        text += print(" -1%10d%5d%5d%5d\n", e + 1, 1, 0, 1);
        text += print(" -2%10d%10d%10d%10d%10d%10d%10d%10d\n", b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]);
    }
    text += " -3\n";
    for (int state = 0; state < 3; ++state) {
        // At the last state the nodes that the second brick has alone are left out.
        text += print("  100CL%5d%12.5f%12d%20s%2d%5d%10s%2d\n", 100 + state, double(state), state == 2 ? 8 : nodes, "", 0,
                      state + 1, "", 1);
        text += " -4  DISP        4    1\n -5  D1          1    2    1    0\n -5  D2          1    2    2    0\n";
        text += " -5  D3          1    2    3    0\n -5  ALL         1    2    0    0    1ALL\n";
        for (int n = 1; n <= nodes; ++n) {
            if (state < 2 || n % 3 != 0) {
                text += print(" -1%10d%12.5E%12.5E%12.5E\n", n, 0.1 * state, 0.0, 0.0);
            }
        }
        text += " -3\n";
    }
    return text + " 9999\n";
}

std::string smallMarc(bool removed) {
    std::string text = "=beg=50100 (Analysis Title)\n          small\n=end=\n" + marcMesh(2);
    for (int state = 0; state < 3; ++state) {
        const bool anew = removed && state == 2;
        text += "****\n=beg=51701 (Integer Increment Verification Data)\n" + print("%13d%13d\n=end=\n", anew ? 1 : 0, state + 1);
        text += "=beg=51801 (Real Increment Verification Data)\n" + print("%13d\n%13.6E\n=end=\n", 1, double(state));
        text += anew ? marcMesh(1) : "";
        text += "=beg=52300 (Element Integration Point Values)\n" + print("%13.6E\n", 5.0);
        text += anew ? "" : print("%13.6E\n", !removed && state == 2 ? 0.0 : 5.0);
        text += "=end=\n=beg=52401 (Nodal Results)\n" + print("%13d%13d\nDisplacement\n", 1, 3);
        text += print("%13d%13d%13d%13d%13d%13d\n%13d%13d%13d%13d%13d%13d\n", 1, 0, 0, 3, 0, 0, -1, 0, 0, 0, 0, 0);
        for (int n = 0; n < nodes; n += 2) {
            text += print("%13.6E%13.6E%13.6E%13.6E%13.6E%13.6E\n", 0.1 * state, 0.0, 0.0, 0.1 * state, 0.0, 0.0);
        }
        text += "=end=\n----\n";
    }
    return text + "++++\n";
}

std::string smallCdb(int state) {
    std::string text =
        print("/COM,time=%d\n/PREP7\nET,1,185\nMP,DENS,1,2400\nNBLOCK,6,SOLID,%9d,%9d\n(3i9,6e21.13e3)\n", state, nodes, nodes);
    for (int n = 1; n <= nodes; ++n) {
        const auto x = place(n);
        text += print("%9d%9d%9d%21.13E%21.13E%21.13E\n", n, 0, 0, x[0] + 0.1 * state, x[1], x[2]);
    }
    text += print("N,R5.3,LOC,       -1,\nEBLOCK,19,SOLID,%9d,%9d\n(19i9)\n", 2, 2);
    for (int e = 0; e < 2; ++e) {
        const auto& b = bricks[static_cast<std::size_t>(e)];
        text += print("%9d%9d%9d%9d%9d%9d%9d%9d%9d%9d%9d", 1, 1, 1, 1, 0, state == 2 && e == 1 ? 1 : 0, 0, 0, 8, 0, e + 1);
        text += print("%9d%9d%9d%9d%9d%9d%9d%9d\n", b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]);
    }
    return text + print("%9d\nFINISH\n", -1);
}

std::string smallRst(int states, const RstHeader& header) {
    RstText text;
    std::vector<int> own = header.bricks, ownNodes;
    if (own.empty()) {
        own = {1, 2};
    }
    for (int n = 1; n <= nodes; ++n) {
        const auto uses = [n](int e) {
            const auto& brick = bricks[static_cast<std::size_t>(e - 1)];
            return std::find(brick.begin(), brick.end(), n) != brick.end();
        };
        if (std::any_of(own.begin(), own.end(), uses)) {
            ownNodes.push_back(n);
        }
    }
    std::vector<std::int32_t> standard(100), results(header.words), geometry(header.words);
    standard[0] = 12;
    text.integers(standard);
    const std::size_t resultsAt = text.integers(results);
    const std::size_t geometryAt = text.integers(geometry);
    std::vector<std::int32_t> numbers;
    const std::size_t nodesAt = text.words();
    for (const int n : ownNodes) {
        const auto x = place(n);
        text.reals({static_cast<double>(n), x[0], x[1], x[2], 0.0, 0.0, 0.0});
        numbers.push_back(n);
    }
    const std::size_t orderAt = text.integers(numbers);
    const std::size_t typesAt = text.words();
    text.integers({4});  // words from here to the type
    text.integers({1, 185});
    // Two words of places, three around them.
    std::vector<std::int32_t> elementPlaces;
    for (std::size_t e = 0; e < own.size(); ++e) {
        elementPlaces.push_back(static_cast<std::int32_t>(3 + own.size() + 21 * e));
    }
    const std::size_t elementsAt = text.integers(elementPlaces);
    for (const int e : own) {
        std::vector<std::int32_t> values{1, 1, 1, 1, 0, 0, 0, 0, e, 0};
        const auto& brick = bricks[static_cast<std::size_t>(e - 1)];
        values.insert(values.end(), brick.begin(), brick.end());
        text.integers(values);
    }
    // The tables that name the sets stand before them.
    const std::size_t setsAt = text.integers(std::vector<std::int32_t>(6));
    const std::size_t timesAt = text.reals({0.0, 1.0, 2.0});
    for (int state = 0; state < states; ++state) {
        std::vector<std::int32_t> set(header.setWords);
        set[2] = static_cast<std::int32_t>(ownNodes.size());
        set[10] = static_cast<std::int32_t>(header.setWords) + 3;
        set[19] = 3;
        set[20] = 1, set[21] = 2, set[22] = 3;
        text.set(setsAt, static_cast<std::size_t>(state), {text.integers(set)});
        std::vector<double> moved;
        for (std::size_t n = 0; n < ownNodes.size(); ++n) {
            moved.insert(moved.end(), {0.1 * state, 0.0, header.unset ? 0x1p100 : 0.0});
        }
        text.reals(moved);
    }
    text.set(resultsAt, 2, {ownNodes.size(), 3});
    if (!header.bricks.empty()) {
        constexpr std::size_t modelNodes = 48;
        text.set(resultsAt, modelNodes, {std::size_t{nodes}});
    }
    text.set(resultsAt, 7, {static_cast<std::size_t>(header.analysis), static_cast<std::size_t>(states)});
    text.set(resultsAt, 10, {setsAt, timesAt});
    text.set(resultsAt, 14, {orderAt, geometryAt});
    text.set(geometryAt, 3, {ownNodes.size(), own.size()});
    text.set(geometryAt, 6, {typesAt});
    text.set(geometryAt, 8, {nodesAt});
    text.set(geometryAt, 10, {elementsAt});
    return text.get();
}

std::string smallDeck() {
    return "*HEADING\n two bricks\n** a comment\n*Element, type=C3D8R, elset=Wall\n1, 1, 2, 5, 4,\n7, 8, 11, 10\n2, 2, 3, 6, "
           "5,\n8, 9, 12, 11\n"
           "*SOLID SECTION, ELSET=WALL, MATERIAL=stone\n,\n*MATERIAL, NAME=Stone\n*DENSITY\n2400.,\n"
           "*STEP\n*END STEP\n*STEP\n*END STEP\n*STEP\n*MODEL CHANGE, TYPE=ELEMENT, REMOVE\n2\n*END STEP\n";
}

}  // namespace rubble::io
