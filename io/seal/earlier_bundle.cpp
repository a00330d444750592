#include "io/seal/earlier_bundle.h"

#include <algorithm>

#include "io/base/files.h"
#include "io/base/sha256.h"
#include "io/seal/unpacked_bundle.h"
#include "io/seal/zip_container.h"

namespace rubble::io {

EarlierBundle bundleBefore(PackedBag& packed, const std::string& folder, const Execution& execution) {
    const auto begins = [](const std::string& start) {
        return [&start](const std::string& place) { return place.starts_with(start); };
    };
    std::vector<std::string> places;
    for (const ZipReader::Entry& entry : packed.entries()) {
        places.push_back(packed.placeOf(entry));
    }
    const auto end = std::find_if(places.begin(), places.end(), begins(folder));
    const std::string payload = bag::payload;
    const auto data = std::find_if(places.begin(), end, begins(payload));
    // When it was sealed the list of files about the bag stood in front of the payload; what is added goes before the list.
    const bool asSealed =
        std::all_of(data, end, [&](const std::string& place) { return place.starts_with(payload) || place == bag::tagManifest; });
    const auto listAt = asSealed ? data : end;
    const Manifest now = manifestOf(packed.text(bag::tagManifest).value_or("")).value_or(Manifest());
    Manifest then;
    for (const auto& [place, digest] : now) {
        if (std::find(places.begin(), end, place) != end) {
            then[place] = digest;
        }
    }
    const ScratchFolder scratch;
    const std::string file = scratch.path() + "/earlier.zip";
    ZipWriter zip(file);
    for (auto place = places.begin();; ++place) {
        if (place == listAt) {
            zip.add(packed.folder() + bag::tagManifest, manifestText(then));
        }
        if (place == end) {
            break;
        }
        if (*place == bag::tagManifest) {
            continue;
        }
        const ZipReader::Entry& entry = packed.entries()[static_cast<std::size_t>(place - places.begin())];
        zip.open(entry.name, entry.bytes);
        packed.zip().read(entry, [&](const char* bytes, std::size_t size) {
            zip.write(bytes, size);
            execution.check();
        });
        zip.close();
    }
    zip.finish();
    return {sha256OfFile(file, [&](std::size_t) { execution.check(); }),
            std::find(end, places.end(), bag::stampAnswer) != places.end()};
}

}  // namespace rubble::io
