#include "baker/card/card.h"

#include "baker/card/close_gaps.h"
#include "baker/card/outline_simplify.h"
#include "baker/card/planar_mesh.h"
#include "baker/file_faults.h"
#include "baker/file_io.h"
#include "baker/printable_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <span>

namespace lr::baker {
namespace {

constexpr std::size_t max_file_bytes = std::size_t{1} << 30;
constexpr std::size_t max_triangles = 200000;
constexpr int most_listed = 8;
// Largest displacement of an outline by simplification, in pixels. Stairs of a mask without grey levels deviate by half a pixel from the intended
// line; grey levels place it within about a tenth.
constexpr double stairs_tolerance = 0.7;
constexpr double grey_tolerance = 0.2;
// The same in edge lengths, since a mesh cannot represent finer detail.
constexpr double edge_tolerance = 0.02;
// Limits above which an outline is frayed: its length over triangles times edge length, and its corners over triangles.
constexpr double most_outline = 1.0, most_corners = 0.5, spare_corners = 150.0;
// The same of an outline whose gaps are closed anyway: with more it needs up to twice the triangles.
constexpr double most_corners_closed = 0.25;
constexpr double short_edge = 0.25; // in edge lengths: see simplify_outlines

// A --speck above the default asks to close pinholes.
bool keeps_pinholes(const CardOptions& options) {
    return options.speck <= CardOptions{}.speck;
}

std::string rounded(double value, double unit = 0.1) {
    return shortest(std::round(value / unit) / std::round(1.0 / unit));
}

bool check_options(const CardOptions& o, Faults& faults) {
    const auto in_range = [&](double value, double low, double high, const char* where, const char* unit) {
        if (value >= low && value <= high) return true;
        return fail(faults, FaultId::parameter_out_of_range, where,
                    "The value " + shortest(value) + " is outside its range.",
                    "Give a number from " + shortest(low) + " to " + shortest(high) + unit + ".");
    };
    bool good = in_range(o.width, 1e-6, 1e3, "width", " m");
    good = in_range(o.alpha, 0.001, 0.999, "alpha", "") && good;
    good =
        in_range(static_cast<double>(o.triangles), 20.0, static_cast<double>(max_triangles), "triangles", "") && good;
    return in_range(o.speck, 0.0, 1.0, "speck", "") && good;
}

class CardMesher {
public:
    CardMesher(const CardOptions& options, const std::string& where, Mesh& out, CardReport& report, Faults& faults)
        : options_(options), where_(where), out_(out), report_(report), faults_(faults) {}

    bool run(const void* bytes, std::size_t size) {
        AlphaMask mask;
        if (!read_alpha_mask(bytes, size, options_.mask_path.empty() ? options_.channel : MaskChannel::luminance,
                             options_.key, where_, mask, faults_))
            return false;
        report_.image_width = mask.width;
        report_.image_height = mask.height;
        Outlines outlines;
        if (!trace_outlines(mask, options_.alpha, options_.speck, keeps_pinholes(options_), where_, outlines, faults_))
            return false;
        report_specks(outlines);
        stairs_ = outlines.stairs;
        report_.pieces = outlines.pieces.size();
        if (!choose(outlines)) return false;
        weigh(mask, outlines.pinholes);
        if (!close_frayed(mask)) return false;
        mask = AlphaMask{};
        return mesh();
    }

private:
    double pixel() const { return options_.width / static_cast<double>(report_.image_width); }

    void report_specks(const Outlines& outlines) {
        const double largest = outlines.pieces.empty() ? 1.0 : outlines.pieces[0].area;
        const auto sentence = [largest](std::size_t count, double area, const char* what, const char* change) {
            return std::to_string(count) + what + (count == 1 ? " (" : "s (") + rounded(area) + " pixels in all, " +
                   rounded(100.0 * area / largest) + " % of the largest region) " + (count == 1 ? "was " : "were ") +
                   change + ".";
        };
        const char* const remedy = "Clean the alpha channel, or give a lower --speck to keep them.";
        if (outlines.specks > 0)
            faults_.push_back({FaultId::image_specks, Severity::warning, where_,
                               sentence(outlines.specks, outlines.speck_area, " speck", "ignored"), remedy});
        if (!outlines.pinholes.empty())
            faults_.push_back({FaultId::image_specks, Severity::warning, where_,
                               sentence(outlines.pinholes.size(), outlines.pinhole_area, " pinhole",
                                        keeps_pinholes(options_) ? "closed for the flow" : "closed"),
                               remedy});
    }

    // "1 at 120,88 (61 %), 2 at 300,90 (39 %)": centres in pixels from the top left, as in image editors.
    std::string name_pieces(const std::vector<Piece>& pieces) const {
        double total = 0.0;
        for (const Piece& piece : pieces) total += piece.area;
        std::string text;
        for (std::size_t i = 0; i < pieces.size() && i < most_listed; ++i) {
            Eigen::Vector2d low = pieces[i].loops[0][0], high = low;
            for (const Eigen::Vector2d& p : pieces[i].loops[0]) {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            const Eigen::Vector2d centre = 0.5 * (low + high);
            text += (i > 0 ? ", " : "") + std::to_string(i + 1) + " at " + rounded(centre.x(), 1.0) + "," +
                    rounded(static_cast<double>(report_.image_height) - centre.y(), 1.0) + " (" +
                    rounded(100.0 * pieces[i].area / total) + " %)";
        }
        if (pieces.size() > most_listed) text += " and " + std::to_string(pieces.size() - most_listed) + " more";
        return text;
    }

    // Replaces the outline by that of these regions.
    void take(std::span<Piece> pieces) {
        loops_.clear();
        area_ = 0.0;
        report_.holes = 0;
        for (Piece& piece : pieces) {
            report_.holes += piece.loops.size() - 1;
            area_ += piece.area;
            for (Loop& loop : piece.loops) loops_.push_back(std::move(loop));
        }
        report_.traced_area = area_ * pixel() * pixel();
    }

    bool choose(Outlines& outlines) {
        std::vector<Piece>& pieces = outlines.pieces;
        if (options_.piece && (*options_.piece < 1 || *options_.piece > pieces.size()))
            return fail(faults_, FaultId::parameter_unknown, "piece",
                        "The image has no region " + std::to_string(*options_.piece) + ".",
                        "It has: " + name_pieces(pieces) + ".");
        const std::size_t first = options_.piece ? *options_.piece - 1 : 0;
        const std::size_t end = options_.all_pieces ? pieces.size() : first + 1;
        if (pieces.size() > 1 && !options_.piece)
            faults_.push_back({FaultId::image_several_pieces, Severity::warning, where_,
                               "The image has " + std::to_string(pieces.size()) +
                                   " separate regions: " + name_pieces(pieces) + "; " +
                                   (options_.all_pieces ? "all were baked as one body." : "the largest was baked."),
                               options_.all_pieces ? "Choose one with --piece N if they are separate bodies."
                                                   : "Give --islands to bake each by itself, --piece N for one of "
                                                     "them, or --piece all for one body."});
        take({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.begin() + static_cast<std::ptrdiff_t>(end)});
        region_ = loops_;
        return true;
    }

    // Closes the narrow gaps of an outline that is too long for the wanted triangles, such as a fern's: its mesh would take minutes. Gaps narrower than
    // the viscous length are closed to the flow too. Takes the smallest reach of 1, 2, 4, ... pixels that is enough.
    bool close_frayed(const AlphaMask& mask) {
        if (!is_frayed(most_corners)) return true;
        const AlphaMask kept = only_region(mask);
        std::size_t reach = 1;
        stairs_ = true;
        for (;; reach *= 2) {
            Outlines outlines;
            Faults ignored;
            if (2 * reach > std::max(mask.width, mask.height) ||
                !trace_outlines(close_gaps(kept, options_.alpha, reach), options_.alpha, options_.speck,
                                keeps_pinholes(options_), where_, outlines, ignored))
                return fail(faults_, FaultId::image_too_ragged, where_,
                            "The outline is too frayed for " + std::to_string(options_.triangles) + " triangles.",
                            "Smooth the mask, reduce the image, or give more --triangles.");
            const std::span<Piece> pieces = outlines.pieces;
            take(options_.all_pieces ? pieces : pieces.first(1));
            if (!is_frayed(most_corners_closed)) break;
        }
        report_.closed_gap = 2.0 * static_cast<double>(reach) * pixel();
        faults_.push_back(
            {FaultId::image_too_ragged, Severity::warning, where_,
             "The outline is too frayed for " + std::to_string(options_.triangles) + " triangles: gaps below about " +
                 std::to_string(2 * reach) + " pixels were closed for the flow, and are " +
                 rounded(100.0 * (1.0 - opaque_.area / area_)) + " % of its surface; mass and inertia are exact.",
             "None needed for a body seen from afar; give more --triangles to keep finer details."});
        return true;
    }

    // Whether the outline is longer than about the sides of the wanted triangles or, simplified as for the mesh, has too many corners for them: each
    // corner costs at least one.
    bool is_frayed(double corners_each) const {
        double length = 0.0;
        for (const Loop& loop : loops_) length += perimeter(loop);
        const auto wanted = static_cast<double>(options_.triangles);
        const double edge = std::sqrt(area_ / (wanted * std::sqrt(3.0) / 4.0));
        if (length > most_outline * wanted * edge) return true;
        std::vector<Loop> loops = loops_;
        simplify(loops, edge);
        std::size_t corners = 0;
        for (const Loop& loop : loops) corners += loop.size();
        return static_cast<double>(corners) > corners_each * wanted + spare_corners;
    }

    void simplify(std::vector<Loop>& loops, double edge) const {
        simplify_outlines(loops, std::max(stairs_ ? stairs_tolerance : grey_tolerance, edge_tolerance * edge),
                          short_edge * edge);
    }

    // Where the chosen regions begin and end along the middle of each line of the image, in turns.
    void cross_lines(const AlphaMask& mask) {
        crossings_.assign(mask.height, {});
        for (const Loop& loop : region_)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Eigen::Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
                const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
                for (auto y = static_cast<std::ptrdiff_t>(std::max(0.0, std::ceil(low - 0.5)));
                     y < static_cast<std::ptrdiff_t>(mask.height) && static_cast<double>(y) + 0.5 < high; ++y)
                    crossings_[static_cast<std::size_t>(y)].push_back(a.x() + (static_cast<double>(y) + 0.5 - a.y()) /
                                                                                  (b.y() - a.y()) * (b.x() - a.x()));
            }
        for (std::vector<double>& at : crossings_) std::sort(at.begin(), at.end());
    }

    // Mass, centre and inertia are those of the traced outline, less the pinholes that are closed for the flow alone.
    void weigh(const AlphaMask& mask, const std::vector<Pinhole>& pinholes) {
        cross_lines(mask);
        for (const Loop& loop : region_) opaque_ += moments(loop, mask.centre());
        for (const Pinhole& hole : pinholes) {
            const std::vector<double>& at = crossings_[hole.pixel / mask.width];
            const double x = static_cast<double>(hole.pixel % mask.width) + 0.5;
            const bool inside = (std::lower_bound(at.begin(), at.end(), x) - at.begin()) % 2 != 0;
            if (inside && keeps_pinholes(options_)) opaque_ += hole.moments;
        }
        const double square = pixel() * pixel();
        report_.opaque = {square * opaque_.area, square * pixel() * opaque_.first, square * square * opaque_.second};
    }

    // The opacity within the chosen regions and near them, without the others.
    AlphaMask only_region(const AlphaMask& mask) const {
        if (options_.all_pieces || report_.pieces == 1) return mask;
        AlphaMask kept{mask.width, mask.height, std::vector<uint16_t>(mask.opacity.size(), 0)};
        for (std::size_t y = 0; y < mask.height; ++y) {
            const std::vector<double>& at = crossings_[y];
            for (std::size_t i = 0; i + 1 < at.size(); i += 2)
                for (auto x = static_cast<std::size_t>(std::max(0.0, at[i]));
                     x < mask.width && static_cast<double>(x) < at[i + 1]; ++x)
                    kept.opacity[y * mask.width + x] = mask.opacity[y * mask.width + x];
        }
        return kept;
    }

    bool mesh() {
        const auto wanted = static_cast<double>(options_.triangles);
        double edge = std::sqrt(area_ / (wanted * std::sqrt(3.0) / 4.0)); // equilateral
        PlanarMesh best;
        std::vector<Loop> outline;
        double best_miss = HUGE_VAL;
        // The number of triangles is proportional to edge length^-2 or, in stems, ^-1.
        for (int attempt = 0; attempt < 5 && best_miss > 1.05; ++attempt) {
            std::vector<Loop> loops = loops_;
            simplify(loops, edge);
            PlanarMesh mesh;
            if (!triangulate_region(loops, edge, max_triangles, mesh)) break;
            const double count = static_cast<double>(mesh.faces.size()),
                         miss = std::max(count / wanted, wanted / count);
            if (miss < best_miss) {
                best_miss = miss;
                best = std::move(mesh);
                outline = std::move(loops);
                report_.edge = edge * pixel();
            }
            edge *= std::clamp(std::sqrt(count / wanted), 0.5, 2.0);
        }
        if (best.faces.empty())
            return fail(faults_, FaultId::image_too_ragged, where_,
                        "The outline cannot be meshed with " + std::to_string(max_triangles) + " triangles.",
                        "Smooth the mask, or reduce the image.");
        if (static_cast<double>(best.faces.size()) > 1.5 * wanted)
            faults_.push_back({FaultId::image_too_ragged, Severity::warning, where_,
                               "The outline needs " + std::to_string(best.faces.size()) + " triangles; " +
                                   std::to_string(options_.triangles) + " were requested.",
                               "Smooth the mask, or reduce the image, for fewer."});
        write(best, outline);
        return true;
    }

    void write(const PlanarMesh& mesh, const std::vector<Loop>& outline) {
        const double metres = pixel();
        const Eigen::Vector2d centre(0.5 * static_cast<double>(report_.image_width),
                                     0.5 * static_cast<double>(report_.image_height));
        for (const Eigen::Vector2d& p : mesh.vertices) {
            const Eigen::Vector2d at = metres * (p - centre);
            out_.vertices.emplace_back(at.x(), at.y(), 0.0);
        }
        out_.faces = mesh.faces;
        PlaneMoments flow;
        for (const Loop& loop : outline) {
            report_.area += signed_area(loop) * metres * metres;
            report_.outline += perimeter(loop) * metres;
            flow += moments(loop, centre);
        }
        if (report_.closed_gap > 0.0)
            report_.off_centre = metres * (opaque_.first / opaque_.area - flow.first / flow.area);
        report_.smallest_angle = smallest_angle(mesh);
    }

    const CardOptions& options_;
    const std::string& where_;
    Mesh& out_;
    CardReport& report_;
    Faults& faults_;
    std::vector<Loop> loops_, region_; // pixels; region_: before smoothing
    std::vector<std::vector<double>> crossings_;
    PlaneMoments opaque_; // pixels, about the centre of the image
    double area_ = 0.0;
    bool stairs_ = false;
};
} // namespace

std::size_t count_card_pieces(const void* bytes, std::size_t size, const CardOptions& options, const std::string& where,
                              Faults& faults) {
    AlphaMask mask;
    Outlines outlines;
    if (!check_options(options, faults)) return 0;
    try {
        const MaskChannel channel = options.mask_path.empty() ? options.channel : MaskChannel::luminance;
        if (!read_alpha_mask(bytes, size, channel, options.key, where, mask, faults) ||
            !trace_outlines(mask, options.alpha, options.speck, keeps_pinholes(options), where, outlines, faults))
            return 0;
    } catch (const std::bad_alloc&) {
        fail(faults, FaultId::image_unreadable, where, "The image does not fit into memory.", "Reduce its resolution.");
        return 0;
    }
    return outlines.pieces.size();
}

bool read_card_memory(const void* bytes, std::size_t size, const CardOptions& options, const std::string& where,
                      Mesh& out, CardReport& report, Faults& faults) {
    out = Mesh{};
    report = CardReport{};
    if (!check_options(options, faults)) return false;
    try {
        return CardMesher(options, where, out, report, faults).run(bytes, size);
    } catch (const std::bad_alloc&) {
        return fail(faults, FaultId::image_unreadable, where, "The image does not fit into memory.",
                    "Reduce its resolution.");
    }
}

bool read_card(const std::string& path_utf8, const CardOptions& options, Mesh& out, CardReport& report,
               Faults& faults) {
    std::vector<uint8_t> bytes;
    if (!read_file(path_utf8, max_file_bytes, bytes, faults)) return false;
    if (!read_card_memory(bytes.data(), bytes.size(), options, path_utf8, out, report, faults)) return false;
    const std::filesystem::path path = to_path(path_utf8);
    const std::u8string stem = path.stem().u8string();
    out.name = valid_utf8(std::string(stem.begin(), stem.end()));
    return true;
}
} // namespace lr::baker
