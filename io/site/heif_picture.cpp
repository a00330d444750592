#include "io/site/heif_picture.h"

#include <libheif/heif.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

namespace rubble::io {

namespace {

void check(const heif_error& error) {
    if (error.code != heif_error_Ok) {
        throw std::runtime_error(error.message != nullptr ? error.message : "unknown error");
    }
}

struct FreeImage {
    void operator()(heif_image* own) const { heif_image_release(own); }
};
struct FreeOptions {
    void operator()(heif_decoding_options* own) const { heif_decoding_options_free(own); }
};

/// Mean colour of the stored pixels that fall into one.
std::array<std::uint8_t, 3> meanOf(const std::uint8_t* stored, std::size_t stride, std::array<int, 4> box) {
    std::array<std::uint64_t, 3> sum{};
    for (int y = box[1]; y < box[3]; ++y) {
        const std::uint8_t* pixel = stored + static_cast<std::size_t>(y) * stride + 3 * static_cast<std::size_t>(box[0]);
        for (int x = box[0]; x < box[2]; ++x, pixel += 3) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                sum[channel] += pixel[channel];
            }
        }
    }
    const auto count = static_cast<std::uint64_t>(box[2] - box[0]) * static_cast<std::uint64_t>(box[3] - box[1]);
    std::array<std::uint8_t, 3> mean{};
    std::transform(sum.begin(), sum.end(), mean.begin(),
                   [count](std::uint64_t each) { return static_cast<std::uint8_t>((each + count / 2) / count); });
    return mean;
}

}  // namespace

struct HeifPicture::Parts {
    struct FreeContext {
        void operator()(heif_context* own) const { heif_context_free(own); }
    };
    struct FreeHandle {
        void operator()(heif_image_handle* own) const { heif_image_handle_release(own); }
    };
    std::unique_ptr<heif_context, FreeContext> context;
    std::unique_ptr<heif_image_handle, FreeHandle> handle;
};

bool looksLikeHeif(const std::string& path) {
    std::array<char, 12> head{};
    std::ifstream file(path, std::ios::binary);
    return file.read(head.data(), head.size()) && std::equal(head.begin() + 4, head.begin() + 8, "ftyp");
}

HeifPicture::HeifPicture(const std::string& path) : m_parts(std::make_unique<Parts>()) {
    m_parts->context.reset(heif_context_alloc());
    check(heif_context_read_from_file(m_parts->context.get(), path.c_str(), nullptr));
    heif_image_handle* primary = nullptr;
    check(heif_context_get_primary_image_handle(m_parts->context.get(), &primary));
    m_parts->handle.reset(primary);
}

HeifPicture::~HeifPicture() = default;

int HeifPicture::width() const {
    return heif_image_handle_get_width(m_parts->handle.get());
}

int HeifPicture::height() const {
    return heif_image_handle_get_height(m_parts->handle.get());
}

std::string HeifPicture::exif() const {
    heif_item_id id = 0;
    if (heif_image_handle_get_list_of_metadata_block_IDs(m_parts->handle.get(), "Exif", &id, 1) != 1) {
        return {};
    }
    std::string block(heif_image_handle_get_metadata_size(m_parts->handle.get(), id), '\0');
    constexpr std::size_t before = 4;  // bytes that say how many more stand before the TIFF
    if (block.size() <= before || heif_image_handle_get_metadata(m_parts->handle.get(), id, block.data()).code != heif_error_Ok) {
        return {};
    }
    std::size_t skip = 0;
    for (std::size_t k = 0; k < before; ++k) {
        skip = skip << 8 | static_cast<unsigned char>(block[k]);
    }
    return skip < block.size() - before ? block.substr(before + skip) : std::string();
}

std::vector<std::uint8_t> HeifPicture::pixels(int wide, int high) const {
    const std::unique_ptr<heif_decoding_options, FreeOptions> options(heif_decoding_options_alloc());
    options->convert_hdr_to_8bit = 1;
    heif_image* decoded = nullptr;
    check(heif_decode_image(m_parts->handle.get(), &decoded, heif_colorspace_RGB, heif_chroma_interleaved_RGB, options.get()));
    const std::unique_ptr<heif_image, FreeImage> image(decoded);
    int stride = 0;
    const std::uint8_t* stored = heif_image_get_plane_readonly(decoded, heif_channel_interleaved, &stride);
    const int w = heif_image_get_width(decoded, heif_channel_interleaved);
    const int h = heif_image_get_height(decoded, heif_channel_interleaved);
    if (stored == nullptr || w < 1 || h < 1) {
        throw std::runtime_error("no pixels");
    }
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
    const auto edge = [](int of, int parts, int whole) { return static_cast<int>(static_cast<std::int64_t>(of) * whole / parts); };
    for (int y = 0; y < high; ++y) {
        const int top = std::min(edge(y, high, h), h - 1);
        const int bottom = std::max(top + 1, edge(y + 1, high, h));
        for (int x = 0; x < wide; ++x) {
            const int left = std::min(edge(x, wide, w), w - 1);
            const int right = std::max(left + 1, edge(x + 1, wide, w));
            const auto mean = meanOf(stored, static_cast<std::size_t>(stride), {left, top, right, bottom});
            rgb.insert(rgb.end(), mean.begin(), mean.end());
        }
    }
    return rgb;
}

}  // namespace rubble::io
