#include "asset/asset_file.h"

#include "asset_generated.h"
#include "base/fnv1a.h"
#include "base/supported_platform.h"

#include <algorithm>
#include <cstring>

namespace lr {
namespace {

constexpr size_t max_asset_bytes = size_t{1} << 30;

uint64_t checksum_without(const uint8_t* bytes, size_t size, size_t field_offset) {
    Fnv1a hash;
    hash.add(bytes, field_offset);
    for (int i = 0; i < 8; ++i) hash.add_byte(0);
    hash.add(bytes + field_offset + 8, size - field_offset - 8);
    return hash.value();
}

// Offset of the checksum in the file; 0 if it is absent.
size_t checksum_offset(const format::Asset& asset, const uint8_t* bytes) {
    // Generated tables have no fields besides those of flatbuffers::Table, but inherit it privately.
    const uint8_t* at = reinterpret_cast<const flatbuffers::Table&>(asset).GetAddressOf(format::Asset::VT_CHECKSUM);
    return at ? static_cast<size_t>(at - bytes) : 0;
}

// Reads fields that passed FlatBuffers' verifier, which checks presence and bounds, but not the alignment of eight-byte values in vectors and structs.
class Decoder {
public:
    explicit Decoder(Faults& faults) : faults_(faults) {}
    bool ok() const { return ok_; }

    template <class T> void vector(const flatbuffers::Vector<T>* from, std::vector<T>& to) {
        to.resize(from->size());
        if (!to.empty()) std::memcpy(to.data(), from->Data(), sizeof(T) * to.size());
    }
    template <class T, size_t N>
    void array(const flatbuffers::Vector<T>* from, std::array<T, N>& to, const char* field) {
        if (from->size() != N)
            ok_ = fail(faults_, FaultId::asset_wrong_length, field,
                       "It has " + std::to_string(from->size()) + " values, not " + std::to_string(N) + ".");
        else
            std::memcpy(to.data(), from->Data(), sizeof to);
    }
    void vector3(const format::Vec3* from, std::array<double, 3>& to) {
        if (from) std::memcpy(to.data(), from, sizeof to);
    }

private:
    Faults& faults_;
    bool ok_ = true;
};

#define LR_VECTOR(name, ...) read.vector3(from.name(), out.name);
#define LR_NUMBER(name, ...) out.name = from.name();
void decode(const format::Aerodynamics& from, AerodynamicData& out, Decoder& read) {
    read.array(from.axes(), out.axes, "aerodynamics.axes");
    LR_AERODYNAMIC_VECTORS(LR_VECTOR)
    LR_AERODYNAMIC_NUMBERS(LR_NUMBER)
}

void decode(const format::Station& from, StationData& out, Decoder& read) {
    read.array(from.axes(), out.axes, "stations.axes");
    LR_STATION_VECTORS(LR_VECTOR)
    LR_STATION_NUMBERS(LR_NUMBER)
}

void decode(const format::Turbulence& from, TurbulenceData& out, Decoder& read) {
    read.vector(from.chi(), out.chi);
    read.vector(from.epsilon(), out.epsilon);
    read.array(from.cells(), out.cells, "turbulence.cells");
    read.array(from.domain(), out.domain, "turbulence.domain");
    LR_TURBULENCE_NUMBERS(LR_NUMBER)
}
#undef LR_VECTOR
#undef LR_NUMBER

bool decode(const format::Asset& a, AssetData& out, Faults& faults) {
    Decoder read(faults);
    out.name = a.name()->str();
    out.mass = a.mass();
    out.volume = a.volume();
    out.density = a.density();
    read.vector3(a.center_of_mass(), out.center_of_mass);
    read.vector3(a.center_of_buoyancy(), out.center_of_buoyancy);
    read.array(a.inertia(), out.inertia, "inertia");
    read.array(a.added_mass(), out.added_mass, "added_mass");
    read.array(a.added_mass_error(), out.added_mass_error, "added_mass_error");
    format::Fluid fluid;
    format::Lengths lengths;
    std::memcpy(&fluid, a.fluid(), sizeof fluid);
    std::memcpy(&lengths, a.lengths(), sizeof lengths);
    out.fluid_density = fluid.density();
    out.fluid_viscosity = fluid.viscosity();
    out.length_d = lengths.d();
    out.length_b = lengths.b();
    out.length_l = lengths.l();
    out.projected_area = a.projected_area();
    out.u0 = a.u0();
    decode(*a.turbulence(), out.turbulence, read);
    decode(*a.aerodynamics(), out.aerodynamics, read);
    // One more than allowed suffices to refuse them.
    const size_t stations = a.stations() ? std::min<size_t>(a.stations()->size(), most_stations + 1) : 0;
    out.stations.assign(stations, {});
    for (size_t i = 0; i < stations; ++i)
        decode(*a.stations()->Get(static_cast<flatbuffers::uoffset_t>(i)), out.stations[i], read);
    read.vector(a.hull()->vertices(), out.hull.vertices);
    read.vector(a.hull()->triangles(), out.hull.triangles);
    const format::Provenance& p = *a.provenance();
    out.provenance = {p.tool()->str(), p.tool_version()->str(), p.source()->str(),
                      p.input_hash(),  p.options()->str(),      p.faces(),
                      p.vertices()};
    return read.ok();
}

#define LR_VECTOR(name, ...)                                                                                           \
    const format::Vec3 name(from.name[0], from.name[1], from.name[2]);                                                 \
    to.add_##name(&name);
#define LR_NUMBER(name, ...) to.add_##name(from.name);
flatbuffers::Offset<format::Aerodynamics> encode(const AerodynamicData& from, flatbuffers::FlatBufferBuilder& b) {
    const auto axes = b.CreateVector(from.axes.data(), from.axes.size());
    format::AerodynamicsBuilder to(b);
    to.add_axes(axes);
    LR_AERODYNAMIC_VECTORS(LR_VECTOR)
    LR_AERODYNAMIC_NUMBERS(LR_NUMBER)
    return to.Finish();
}

flatbuffers::Offset<format::Station> encode(const StationData& from, flatbuffers::FlatBufferBuilder& b) {
    const auto axes = b.CreateVector(from.axes.data(), from.axes.size());
    format::StationBuilder to(b);
    to.add_axes(axes);
    LR_STATION_VECTORS(LR_VECTOR)
    LR_STATION_NUMBERS(LR_NUMBER)
    return to.Finish();
}

flatbuffers::Offset<format::Turbulence> encode(const TurbulenceData& from, flatbuffers::FlatBufferBuilder& b) {
    const auto chi = b.CreateVector(from.chi), epsilon = b.CreateVector(from.epsilon);
    const auto cells = b.CreateVector(from.cells.data(), from.cells.size());
    const auto domain = b.CreateVector(from.domain.data(), from.domain.size());
    format::TurbulenceBuilder to(b);
    to.add_chi(chi);
    to.add_epsilon(epsilon);
    to.add_cells(cells);
    to.add_domain(domain);
    LR_TURBULENCE_NUMBERS(LR_NUMBER)
    return to.Finish();
}
#undef LR_VECTOR
#undef LR_NUMBER
} // namespace

std::vector<uint8_t> write_asset(const AssetData& d) {
    flatbuffers::FlatBufferBuilder b(4096);
    // Forced: a value that happens to be 0 must not look like a missing field.
    b.ForceDefaults(true);
    const auto name = b.CreateString(d.name);
    const auto inertia = b.CreateVector(d.inertia.data(), d.inertia.size());
    const auto added_mass = b.CreateVector(d.added_mass.data(), d.added_mass.size());
    const auto added_mass_error = b.CreateVector(d.added_mass_error.data(), d.added_mass_error.size());
    const auto turbulence = encode(d.turbulence, b);
    const auto hull = format::CreateHull(b, b.CreateVector(d.hull.vertices), b.CreateVector(d.hull.triangles));
    const auto& p = d.provenance;
    const auto provenance =
        format::CreateProvenance(b, b.CreateString(p.tool), b.CreateString(p.tool_version), b.CreateString(p.source),
                                 p.input_hash, b.CreateString(p.options), p.faces, p.vertices);
    const auto aerodynamics = encode(d.aerodynamics, b);
    std::vector<flatbuffers::Offset<format::Station>> each;
    for (const StationData& station : d.stations) each.push_back(encode(station, b));
    const auto stations = each.empty() ? 0 : b.CreateVector(each);
    const format::Vec3 com(d.center_of_mass[0], d.center_of_mass[1], d.center_of_mass[2]);
    const format::Vec3 cob(d.center_of_buoyancy[0], d.center_of_buoyancy[1], d.center_of_buoyancy[2]);
    const format::Fluid fluid(d.fluid_density, d.fluid_viscosity);
    const format::Lengths lengths(d.length_d, d.length_b, d.length_l);
    const auto root = format::CreateAsset(b, asset_format_version, 0, name, d.mass, d.volume, d.density, &com, &cob,
                                          inertia, added_mass, added_mass_error, &fluid, &lengths, d.projected_area,
                                          d.u0, turbulence, hull, provenance, aerodynamics, stations);
    format::FinishAssetBuffer(b, root);

    std::vector<uint8_t> bytes(b.GetBufferPointer(), b.GetBufferPointer() + b.GetSize());
    const size_t at = checksum_offset(*format::GetAsset(bytes.data()), bytes.data());
    const uint64_t sum = checksum_without(bytes.data(), bytes.size(), at);
    for (size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<uint8_t>(sum >> (8 * i));
    return bytes;
}

bool read_asset(const void* bytes, size_t size, AssetData& out, Faults& faults) {
    if (size < 16)
        return fail(faults, FaultId::asset_too_short, "byte " + std::to_string(size),
                    "The file ends before its header.");
    if (size > max_asset_bytes) return fail(faults, FaultId::file_too_large, "file", "An asset is at most 1 GiB.");
    // FlatBuffers requires aligned eight-byte values; the caller's bytes can have any alignment.
    std::vector<uint64_t> aligned((size + 7) / 8);
    std::memcpy(aligned.data(), bytes, size);
    const auto* data = reinterpret_cast<const uint8_t*>(aligned.data());

    if (!format::AssetBufferHasIdentifier(data))
        return fail(faults, FaultId::asset_foreign, "byte 4", "The identifier is not LRBA: this is not an asset file.",
                    "Give a file that lr_bake made.");
    flatbuffers::Verifier verifier(data, size, 16, 10000);
    if (!format::VerifyAssetBuffer(verifier))
        return fail(faults, FaultId::asset_corrupt, "structure", "The file is truncated or damaged.",
                    "Copy it again from its source, or bake it again.");
    const format::Asset& asset = *format::GetAsset(data);
    if (asset.format_version() > asset_format_version)
        return fail(faults, FaultId::asset_newer_version, "format_version",
                    "The file has format " + std::to_string(asset.format_version()) + ", this library reads up to " +
                        std::to_string(asset_format_version) + ".",
                    "Update the library, or bake with the baker of this version.");
    const size_t at = checksum_offset(asset, data);
    if (asset.format_version() == 0 || at == 0)
        return fail(faults, FaultId::asset_missing_field, at == 0 ? "checksum" : "format_version",
                    "The field is missing.");
    if (asset.checksum() != checksum_without(data, size, at))
        return fail(faults, FaultId::asset_checksum, "checksum", "The bytes have changed since they were written.",
                    "Copy it again from its source, or bake it again.");
    return decode(asset, out, faults) && check_asset(out, faults) && check_plausible(out, faults);
}
} // namespace lr
