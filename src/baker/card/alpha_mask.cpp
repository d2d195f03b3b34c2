#include "baker/card/alpha_mask.h"

#include "baker/file_faults.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <new>

namespace lr::baker {
namespace {

struct Input {
    const png_byte* bytes;
    std::size_t left;
    char message[160];
};

struct Rows {
    std::vector<png_byte> row;
    AlphaMask mask;
    KeyColour key{};
    bool has_alpha = false;
    bool out_of_memory = false;
};

extern "C" {
static void read_bytes(png_structp png, png_bytep out, png_size_t count) {
    auto* input = static_cast<Input*>(png_get_io_ptr(png));
    if (count > input->left) png_error(png, "the file ends too early");
    std::memcpy(out, input->bytes, count);
    input->bytes += count;
    input->left -= count;
}

[[noreturn]] static void on_error(png_structp png, png_const_charp message) {
    auto* input = static_cast<Input*>(png_get_error_ptr(png));
    std::strncpy(input->message, message, sizeof input->message - 1);
    png_longjmp(png, 1);
}

static void on_warning(png_structp, png_const_charp) {}
}

bool resize(Rows& rows, std::size_t row_bytes) {
    try {
        rows.row.assign(row_bytes, 0);
        rows.mask.opacity.assign(rows.mask.width * rows.mask.height, 0);
    } catch (const std::bad_alloc&) {
        rows.out_of_memory = true;
    }
    return !rows.out_of_memory;
}

uint16_t sample(const png_byte* at, bool wide) {
    return wide ? static_cast<uint16_t>(at[0] << 8 | at[1]) : static_cast<uint16_t>(at[0] * 257);
}

// Rec. 709 weights as integers, so that every machine gets the same mask.
uint16_t luminance(uint32_t r, uint32_t g, uint32_t b) {
    return static_cast<uint16_t>((2126 * r + 7152 * g + 722 * b + 5000) / 10000);
}

// One row of an interlacing pass, or of the image.
void take_row(Rows& rows, MaskChannel channel, png_byte channels, bool wide, png_uint_32 y, png_uint_32 first,
              png_uint_32 step) {
    const std::size_t bytes = wide ? 2 : 1, stride = channels * bytes;
    uint16_t* const to = rows.mask.opacity.data() + (rows.mask.height - 1 - y) * rows.mask.width;
    const png_byte* from = rows.row.data();
    for (std::size_t x = first; x < rows.mask.width; x += step, from += stride) {
        if (channel == MaskChannel::key) {
            int most = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const int colour = sample(from + (channels < 3 ? 0 : k * bytes), wide);
                most = std::max(most, std::abs(colour - 257 * int{rows.key[k]}));
            }
            to[x] = static_cast<uint16_t>(std::min(2 * most, 65535));
        } else if (channel == MaskChannel::alpha)
            to[x] = sample(from + stride - bytes, wide);
        else if (channels < 3)
            to[x] = sample(from, wide);
        else
            to[x] = luminance(sample(from, wide), sample(from + bytes, wide), sample(from + 2 * bytes, wide));
    }
}

// libpng exits by longjmp, so no local object here may have a destructor.
bool decode(png_structp png, png_infop info, MaskChannel channel, Rows& rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_user_limits(png, max_image_side, max_image_side);
    png_set_chunk_malloc_max(png, 64 << 20);
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(png, info);
    rows.mask.width = png_get_image_width(png, info);
    rows.mask.height = png_get_image_height(png, info);
    const bool transparent_color = png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    rows.has_alpha = transparent_color || (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0;
    if (channel == MaskChannel::alpha && !rows.has_alpha) return true;
    png_set_expand(png);
    // Without interlace handling libpng delivers the pixels of each pass, and no second copy of the image is needed.
    const bool interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
    png_read_update_info(png, info);
    const png_byte channels = png_get_channels(png, info);
    const bool wide = png_get_bit_depth(png, info) == 16;
    if (!resize(rows, png_get_rowbytes(png, info))) return false;
    const auto width = static_cast<png_uint_32>(rows.mask.width), height = static_cast<png_uint_32>(rows.mask.height);
    for (int pass = 0; pass < (interlaced ? PNG_INTERLACE_ADAM7_PASSES : 1); ++pass) {
        if (!interlaced) {
            for (png_uint_32 y = 0; y < height; ++y) {
                png_read_row(png, rows.row.data(), nullptr);
                take_row(rows, channel, channels, wide, y, 0, 1);
            }
            continue;
        }
        if (static_cast<png_uint_32>(PNG_PASS_START_COL(pass)) >= width) continue;
        const auto first_row = static_cast<png_uint_32>(PNG_PASS_START_ROW(pass));
        for (png_uint_32 y = first_row; y < height; y += static_cast<png_uint_32>(PNG_PASS_ROW_OFFSET(pass))) {
            png_read_row(png, rows.row.data(), nullptr);
            take_row(rows, channel, channels, wide, y, static_cast<png_uint_32>(PNG_PASS_START_COL(pass)),
                     static_cast<png_uint_32>(PNG_PASS_COL_OFFSET(pass)));
        }
    }
    png_read_end(png, nullptr);
    return true;
}
} // namespace

bool read_alpha_mask(const void* bytes, std::size_t size, MaskChannel channel, const KeyColour& key,
                     const std::string& where, AlphaMask& out, Faults& faults) {
    out = AlphaMask{};
    if (is_placeholder({static_cast<const char*>(bytes), size}))
        return fail(faults, FaultId::image_unreadable, where, "This is a placeholder of Git LFS, not the image itself.",
                    "Fetch the image: git lfs pull.");
    if (size < 8 || png_sig_cmp(static_cast<png_const_bytep>(bytes), 0, 8) != 0)
        return fail(faults, FaultId::image_unreadable, where, "It is not a PNG image.",
                    "Save the texture as PNG with its transparency.");
    Input input{static_cast<const png_byte*>(bytes), size, {}};
    Rows rows;
    rows.key = key;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    rows.out_of_memory = !info;
    bool good = false;
    if (info) {
        png_set_read_fn(png, &input, read_bytes);
        good = decode(png, info, channel, rows);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    if (rows.out_of_memory)
        return fail(faults, FaultId::image_unreadable, where, "The image does not fit into memory.",
                    "Reduce its resolution.");
    if (!good)
        return fail(faults, FaultId::image_unreadable, where,
                    "The PNG image cannot be read: " + std::string(input.message) + ".",
                    "Save it again; 16384 x 16384 pixels at most.");
    if (channel == MaskChannel::alpha && !rows.has_alpha)
        return fail(
            faults, FaultId::image_no_outline, where,
            "The image has no transparency (no alpha channel), so that nothing says where the leaf ends.",
            "Give the colour around the leaf, as --key white; or a black-and-white picture of it, as --mask mask.png "
            "(--mask luminance if this is it); or save the texture with its transparency.");
    out = std::move(rows.mask);
    return true;
}
} // namespace lr::baker
