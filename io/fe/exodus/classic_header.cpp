#include "io/fe/exodus/classic_header.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <vector>

#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::int64_t dimensionTag = 10, variableTag = 11, attributeTag = 12;
// More than any real header; keeps a damaged count from asking for all memory.
constexpr std::int64_t mostEntries = 10'000'000;
// The library copies names to buffers of this length without looking.
constexpr std::int64_t longestName = 256;

struct EndOfFile {};
struct Nonsense {};

/// Reads the big-endian fields of the header, in order.
class HeaderStream {
public:
    explicit HeaderStream(std::istream& in) : m_in(in) {}

    std::int64_t integer(int bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            value = value << 8 | static_cast<std::uint64_t>(byte());
        }
        return bytes == 4 ? static_cast<std::int64_t>(value) : checked(value);
    }
    int byte() {
        const int c = m_in.get();
        if (c < 0) {
            throw EndOfFile{};
        }
        return c;
    }
    /// A count, of the size that the version has for counts.
    std::int64_t count() { return integer(countBytes); }
    std::int64_t entries() {
        const std::int64_t value = count();
        if (value > mostEntries) {
            throw Nonsense{};
        }
        return value;
    }
    std::string name() {
        const std::int64_t length = entries();
        if (length > longestName) {
            throw Nonsense{};
        }
        std::string text;
        for (std::int64_t i = 0; i < length; ++i) {
            text += static_cast<char>(byte());
        }
        skip((4 - length % 4) % 4);
        return text;
    }
    void skip(std::int64_t bytes) {
        for (std::int64_t i = 0; i < bytes; ++i) {
            byte();
        }
    }

    int countBytes = 4;
    int offsetBytes = 4;

private:
    static std::int64_t checked(std::uint64_t value) {
        if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
            throw Nonsense{};
        }
        return static_cast<std::int64_t>(value);
    }

    std::istream& m_in;
};

std::int64_t typeBytes(std::int64_t type) {
    constexpr std::int64_t bytes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    if (type < 1 || type > 11) {
        throw Nonsense{};
    }
    return bytes[type];
}

std::int64_t product(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) {
        throw Nonsense{};
    }
    return result;
}

std::int64_t sum(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    if (__builtin_add_overflow(a, b, &result)) {
        throw Nonsense{};
    }
    return result;
}

// Number of entries of a list that may be absent.
std::int64_t listLength(HeaderStream& in, std::int64_t expectedTag) {
    const std::int64_t tag = in.integer(4);
    const std::int64_t entries = in.entries();
    if (tag != expectedTag && !(tag == 0 && entries == 0)) {
        throw Nonsense{};
    }
    return entries;
}

void skipAttributes(HeaderStream& in) {
    const std::int64_t entries = listLength(in, attributeTag);
    for (std::int64_t i = 0; i < entries; ++i) {
        in.name();
        const std::int64_t width = typeBytes(in.integer(4));
        const std::int64_t bytes = product(in.entries(), width);
        in.skip(sum(bytes, (4 - bytes % 4) % 4));
    }
}

struct Variable {
    std::string name;
    std::int64_t bytes = 0;  ///< of one record, or of all if it has no record dimension
    std::int64_t begin = 0;
    bool record = false;
};

Variable readVariable(HeaderStream& in, const std::vector<std::int64_t>& dimensions) {
    Variable variable;
    variable.name = in.name();
    const std::int64_t rank = in.entries();
    variable.bytes = 1;
    for (std::int64_t i = 0; i < rank; ++i) {
        const auto id = static_cast<std::size_t>(in.count());
        if (id >= dimensions.size()) {
            throw Nonsense{};
        }
        // A length of zero marks the record dimension; it may only come first.
        if (dimensions[id] == 0 && i == 0) {
            variable.record = true;
        } else {
            variable.bytes = product(variable.bytes, dimensions[id]);
        }
    }
    skipAttributes(in);
    variable.bytes = product(variable.bytes, typeBytes(in.integer(4)));
    in.count();  // the size as the header has it, which is wrong for large variables
    variable.begin = in.integer(in.offsetBytes);
    return variable;
}

ClassicExtent extentOf(const std::vector<Variable>& variables, std::int64_t records) {
    const auto padded = [](std::int64_t bytes) { return sum(bytes, (4 - bytes % 4) % 4); };
    std::int64_t recordBytes = 0, recordVariables = 0;
    for (const Variable& variable : variables) {
        if (variable.record) {
            recordBytes = sum(recordBytes, padded(variable.bytes));
        }
        recordVariables += variable.record;
    }
    ClassicExtent extent;
    extent.recordCount = records;
    for (const Variable& variable : variables) {
        if (variable.record && records == 0) {
            continue;
        }
        // Records of a single record variable are not padded.
        const std::int64_t step = recordVariables == 1 ? variable.bytes : recordBytes;
        const std::int64_t before = variable.record ? product(records - 1, step) : 0;
        const std::int64_t end = sum(sum(variable.begin, before), variable.bytes);
        if (end > extent.bytes) {
            extent.bytes = end;
            extent.lastVariable = variable.name;
        }
        std::int64_t& reach = variable.record ? extent.firstBytes : extent.fixedBytes;
        reach = std::max(reach, end - before);
        extent.stateBytes = variable.record ? step : extent.stateBytes;
    }
    return extent;
}

}  // namespace

std::optional<std::int64_t> ClassicExtent::wholeStates(std::int64_t size) const {
    if (!wholeHeader || size < fixedBytes) {
        return std::nullopt;
    }
    if (recordCount == 0 || size < firstBytes) {
        return 0;
    }
    return stateBytes > 0 ? std::min(recordCount, (size - firstBytes) / stateBytes + 1) : recordCount;
}

std::optional<ClassicExtent> classicExtent(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        failToRead(path);
    }
    HeaderStream in(file);
    try {
        if (in.byte() != 'C' || in.byte() != 'D' || in.byte() != 'F') {
            return std::nullopt;
        }
        const int version = in.byte();
        if (version != 1 && version != 2 && version != 5) {
            return std::nullopt;
        }
        in.countBytes = version == 5 ? 8 : 4;
        in.offsetBytes = version == 1 ? 4 : 8;
        // All bits set: the writer did not know the number of records.
        const std::int64_t unknownRecords = 0xffffffff;
        const std::int64_t records = in.count();
        std::vector<std::int64_t> dimensions;
        const std::int64_t dimensionCount = listLength(in, dimensionTag);
        for (std::int64_t i = 0; i < dimensionCount; ++i) {
            in.name();
            dimensions.push_back(in.count());
        }
        skipAttributes(in);
        std::vector<Variable> variables;
        const std::int64_t variableCount = listLength(in, variableTag);
        for (std::int64_t i = 0; i < variableCount; ++i) {
            variables.push_back(readVariable(in, dimensions));
        }
        return extentOf(variables, records == unknownRecords ? 0 : records);
    } catch (const EndOfFile&) {
        ClassicExtent extent;
        extent.wholeHeader = false;
        return extent;
    } catch (const Nonsense&) {
        return std::nullopt;
    }
}

}  // namespace rubble::io
