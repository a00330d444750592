#include "io/fe/exodus/exodus_layout.h"

#include <netcdf.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/hdf5_extent.h"
#include "io/base/trial.h"
#include "io/fe/exodus/classic_header.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/exodus/library_lock.h"

namespace rubble::io {

namespace {

// Deflate cannot do better: a count that needs more than this per byte of the file is damaged.
constexpr std::uint64_t bestCompression = 1100;
constexpr std::uint64_t mostBlocks = 1'000'000;
constexpr std::uint64_t mostVariables = 100'000;
constexpr std::size_t topologyLength = 33;  // the library's buffer, with the end mark

[[noreturn]] void failDamaged(const Message& what) {
    throw ParseError(what, {"exodus.damaged.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
}

[[noreturn]] void failCutOff(const Message& what) {
    throw ParseError(what,
                     {"exodus.cut_off.remedy", "Copy the file again, or wait until the analysis has finished writing it.", {}});
}

[[noreturn]] void failInHeader(const std::string& path, std::int64_t there) {
    failCutOff({"exodus.cut_off", "{0} is cut off: it ends after {1} bytes, inside its header", {path, there}});
}

[[noreturn]] void failNotExodus(const std::string& path, const std::string& why) {
    throw ParseError(
        {"exodus.not_exodus", "{0} is no Exodus II file: {1}", {path, why}},
        {"exodus.not_exodus.remedy",
         "Give the result of the FE analysis as Exodus II (.exo, .e, .ex2). Tables that an .xdmf names are opened through it.",
         {}});
}

// @return  the states at its end that are not whole
std::int64_t requireWholeClassic(const std::string& path, std::int64_t size) {
    const auto extent = classicExtent(path);
    if (!extent) {
        failDamaged({"exodus.header", "{0}: the header of the netCDF file makes no sense", {path}});
    }
    if (!extent->wholeHeader) {
        failInHeader(path, size);
    }
    const std::int64_t whole = extent->wholeStates(size).value_or(0);
    if (extent->bytes > size && whole == 0) {
        failCutOff({"exodus.cut_off.states",
                    "{0} is cut off: it ends after {1} of {2} bytes; the end of {3} is missing",
                    {path, size, extent->bytes, shownName(extent->lastVariable)}});
    }
    return extent->bytes > size ? extent->recordCount - whole : 0;
}

/// A netCDF file that closes itself.
class NetcdfFile {
public:
    explicit NetcdfFile(const std::string& path) {
        const int status = nc_open(path.c_str(), NC_NOWRITE, &m_id);
        if (status != NC_NOERR) {
            failDamaged({"exodus.open", "{0} cannot be opened as netCDF ({1})", {path, nc_strerror(status)}});
        }
    }
    ~NetcdfFile() { nc_close(m_id); }
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;
    operator int() const { return m_id; }

private:
    int m_id = -1;
};

struct Attribute {
    nc_type type = NC_NAT;
    std::size_t length = 0;
};

/// Checks the layout of one open file against what Exodus II says.
class LayoutCheck {
public:
    LayoutCheck(const std::string& path, std::int64_t size)
        : m_path(path), m_mostValues(static_cast<std::uint64_t>(size) * bestCompression), m_file(path) {
        readDimensions();
    }

    void run() {
        requireExodus();
        checkCounts();
        checkBlocks();
        checkVariables();
    }

private:
    void require(int status) const {
        if (status != NC_NOERR) {
            failDamaged({"exodus.structure", "{0}: the structure of the file cannot be read ({1})", {m_path, nc_strerror(status)}});
        }
    }

    void readDimensions() {
        int count = 0;
        require(nc_inq_dimids(m_file, &count, nullptr, 0));
        std::vector<int> ids(static_cast<std::size_t>(count));
        require(nc_inq_dimids(m_file, &count, ids.data(), 0));
        for (const int id : ids) {
            std::array<char, NC_MAX_NAME + 1> name{};
            std::size_t length = 0;
            require(nc_inq_dim(m_file, id, name.data(), &length));
            m_dimensions[name.data()] = length;
        }
    }

    std::uint64_t dimension(const std::string& name) const {
        const auto found = m_dimensions.find(name);
        return found == m_dimensions.end() ? 0 : found->second;
    }

    Attribute attribute(int variable, const char* name) const {
        Attribute result;
        const int status = nc_inq_att(m_file, variable, name, &result.type, &result.length);
        return status == NC_NOERR ? result : Attribute{};
    }

    void requireExodus() const {
        for (const char* name : {"num_dim", "num_nodes", "num_elem", "num_el_blk"}) {
            if (!m_dimensions.count(name)) {
                failNotExodus(m_path, std::string("it has no dimension ") + name);
            }
        }
        // Numbers that the library reads into single variables.
        for (const char* name : {"version", "floating_point_word_size", "floating point word size", "api_version", "api version",
                                 "file_size", "maximum_name_length", "int64_status", "last_written_time"}) {
            const Attribute found = attribute(NC_GLOBAL, name);
            if (found.type == NC_NAT) {
                continue;
            }
            if (found.length != 1 || found.type == NC_CHAR || found.type > NC_UINT64) {
                failDamaged({"exodus.attribute", "{0}: the attribute {1} is not a number", {m_path, name}});
            }
        }
        if (attribute(NC_GLOBAL, "version").type == NC_NAT) {
            failNotExodus(m_path, "it has no attribute version");
        }
    }

    void requireCount(const std::string& name, std::uint64_t most) const {
        if (dimension(name) > most) {
            failDamaged({"exodus.count",
                         "{0}: {1} is {2}, more than the file can hold",
                         {m_path, name, static_cast<std::int64_t>(std::min<std::uint64_t>(dimension(name), INT64_MAX))}});
        }
    }

    void checkCounts() const {
        const std::uint64_t mostIndices = std::min<std::uint64_t>(m_mostValues / 4, std::numeric_limits<std::uint32_t>::max() - 1);
        requireCount("num_nodes", mostIndices);
        requireCount("num_elem", mostIndices);
        requireCount("num_el_blk", mostBlocks);
        requireCount("num_nod_var", mostVariables);
        requireCount("num_elem_var", mostVariables);
        requireCount("time_step", std::min<std::uint64_t>(m_mostValues / 4, std::numeric_limits<int>::max() - 1));
        for (const char* name : {"len_string", "len_name", "len_line"}) {
            requireCount(name, 100'000);
        }
        requireCount("num_dim", 3);
    }

    void checkBlocks() {
        std::set<long long> ids;
        int variable = -1;
        if (nc_inq_varid(m_file, "eb_prop1", &variable) == NC_NOERR) {
            requireShape(variable, "eb_prop1", {dimension("num_el_blk")});
            std::vector<long long> values(dimension("num_el_blk"));
            require(values.empty() ? NC_NOERR : nc_get_var_longlong(m_file, variable, values.data()));
            for (const long long id : values) {
                if (!ids.insert(id).second) {
                    failDamaged(
                        {"exodus.block_twice", "{0}: two blocks have the number {1}", {m_path, static_cast<std::int64_t>(id)}});
                }
            }
        }
        for (std::uint64_t b = 1; b <= dimension("num_el_blk"); ++b) {
            const std::string n = std::to_string(b);
            requireCount("num_el_in_blk" + n, dimension("num_elem"));
            requireCount("num_nod_per_el" + n, 1000);
            requireCount("num_att_in_blk" + n, 10'000);
            if (dimension("num_el_in_blk" + n) * std::max<std::uint64_t>(dimension("num_nod_per_el" + n), 1) > m_mostValues / 4) {
                requireCount("num_el_in_blk" + n, 0);
            }
        }
    }

    void requireShape(int variable, const std::string& name, const std::vector<std::uint64_t>& expected) const {
        int rank = 0;
        require(nc_inq_varndims(m_file, variable, &rank));
        std::vector<int> ids(static_cast<std::size_t>(rank));
        require(nc_inq_vardimid(m_file, variable, ids.data()));
        bool right = ids.size() == expected.size();
        for (std::size_t i = 0; right && i < ids.size(); ++i) {
            std::size_t length = 0;
            require(nc_inq_dimlen(m_file, ids[i], &length));
            right = length == expected[i];
        }
        if (!right) {
            failDamaged({"exodus.shape",
                         "{0}: {1} does not have the shape that the counts of the file give it",
                         {m_path, shownName(name)}});
        }
    }

    // The number behind a prefix: 12 for "connect12"; nothing where other text follows.
    static std::optional<std::string> numberBehind(const std::string& name, const std::string& prefix) {
        const std::string rest = name.starts_with(prefix) ? name.substr(prefix.size()) : "";
        const bool digits = !rest.empty() && rest.find_first_not_of("0123456789") == std::string::npos;
        return digits ? std::optional(rest) : std::nullopt;
    }

    // Shape of a variable of the Exodus II format that the library reads as a whole; nothing for all others.
    std::optional<std::vector<std::uint64_t>> shapeOfVariable(const std::string& name) const {
        using Shape = std::vector<std::uint64_t>;
        const std::uint64_t nodes = dimension("num_nodes"), blocks = dimension("num_el_blk"), steps = dimension("time_step");
        const std::map<std::string, Shape> fixed{{"coordx", {nodes}},
                                                 {"coordy", {nodes}},
                                                 {"coordz", {nodes}},
                                                 {"coord", {dimension("num_dim"), nodes}},
                                                 {"node_num_map", {nodes}},
                                                 {"elem_num_map", {dimension("num_elem")}},
                                                 {"eb_status", {blocks}},
                                                 {exodusPartVariable, {blocks}},
                                                 {"elem_var_tab", {blocks, dimension("num_elem_var")}},
                                                 {"vals_nod_var", {steps, dimension("num_nod_var"), nodes}},
                                                 {"time_whole", {steps}}};
        if (const auto found = fixed.find(name); found != fixed.end()) {
            return found->second;
        }
        if (numberBehind(name, "eb_prop")) {
            return Shape{blocks};
        }
        if (numberBehind(name, "vals_nod_var")) {
            return Shape{steps, nodes};
        }
        if (const auto n = numberBehind(name, "connect")) {
            return Shape{dimension("num_el_in_blk" + *n), dimension("num_nod_per_el" + *n)};
        }
        if (const auto n = numberBehind(name, "attrib")) {
            return Shape{dimension("num_el_in_blk" + *n), dimension("num_att_in_blk" + *n)};
        }
        const std::size_t eb = name.find("eb");
        if (name.starts_with("vals_elem_var") && eb != std::string::npos) {
            if (const auto n = numberBehind(name.substr(eb), "eb")) {
                return Shape{steps, dimension("num_el_in_blk" + *n)};
            }
        }
        return std::nullopt;
    }

    void checkVariables() const {
        int count = 0;
        require(nc_inq_nvars(m_file, &count));
        for (int variable = 0; variable < count; ++variable) {
            std::array<char, NC_MAX_NAME + 1> text{};
            nc_type type = NC_NAT;
            require(nc_inq_varname(m_file, variable, text.data()));
            require(nc_inq_vartype(m_file, variable, &type));
            const std::string name = text.data();
            if (const auto shape = shapeOfVariable(name)) {
                requireShape(variable, name, *shape);
                if (type == NC_CHAR || type > NC_UINT64) {
                    failDamaged({"exodus.type", "{0}: {1} does not hold numbers", {m_path, shownName(name)}});
                }
            }
            if (numberBehind(name, "connect")) {
                const Attribute topology = attribute(variable, "elem_type");
                if (topology.type != NC_CHAR || topology.length > topologyLength) {
                    failDamaged(
                        {"exodus.topology", "{0}: {1} does not say of which type its elements are", {m_path, shownName(name)}});
                }
            }
        }
    }

    const std::string& m_path;
    const std::uint64_t m_mostValues;
    NetcdfFile m_file;
    std::map<std::string, std::uint64_t> m_dimensions;
};

}  // namespace

std::size_t checkExodusLayout(const std::string& path) {
    std::error_code error;
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path, error));
    std::ifstream file(path, std::ios::binary);
    const int first = file.get();
    if (!error && size == 0) {
        failInHeader(path, 0);
    }
    if (error || !file) {
        failToRead(path);
    }
    const LibraryLock lock;
    const auto check = [&] { LayoutCheck(path, size).run(); };
    if (first == 'C') {
        const std::int64_t unfinished = requireWholeClassic(path, size);
        check();
        return static_cast<std::size_t>(unfinished);
    }
    requireWholeHdf5(path);
    static TriedFiles<bool> tried;
    if (!tried.of(path, [&] { return survivesTrial(check); })) {
        failDamaged({"exodus.crash", "{0} is damaged so that the HDF5 library fails on it", {path}});
    }
    return 0;
}

}  // namespace rubble::io
