#include "format/asset_file.h"

#include "asset_generated.h"
#include "format/checksum.h"
#include "format/target.h"

#include <algorithm>
#include <cstring>

namespace lr {
namespace {

constexpr size_t max_asset_bytes = size_t{1} << 30;
constexpr char const* rebake = "Bake the asset again.";

void fail(Faults& faults, FaultId id, std::string where, std::string what, std::string remedy = rebake) {
    faults.push_back({id, Severity::error, std::move(where), std::move(what), std::move(remedy)});
}

uint64_t checksum_without(const uint8_t* bytes, size_t size, size_t field_offset) {
    Fnv1a hash;
    hash.add(bytes, field_offset);
    for (int i = 0; i < 8; ++i) hash.add_byte(0);
    hash.add(bytes + field_offset + 8, size - field_offset - 8);
    return hash.value();
}

// Where the checksum lies in the file, or 0 when it is absent.
size_t checksum_offset(const format::Asset& asset, const uint8_t* bytes) {
    // Generated tables are flatbuffers::Table and nothing else, but keep it private.
    const uint8_t* at = reinterpret_cast<const flatbuffers::Table&>(asset).GetAddressOf(format::Asset::VT_CHECKSUM);
    return at ? static_cast<size_t>(at - bytes) : 0;
}

// FlatBuffers' verifier looks after the bounds of vectors and structs, not after the alignment of eight-byte values.
bool check_alignment(const void* at, size_t alignment, const char* field, Faults& faults) {
    if (reinterpret_cast<uintptr_t>(at) % alignment == 0) return true;
    fail(faults, FaultId::asset_corrupt, field, "The field is not aligned.");
    return false;
}

template <size_t N>
bool copy_array(const flatbuffers::Vector<double>* from, std::array<double, N>& to, const char* field, Faults& faults) {
    if (!from) {
        fail(faults, FaultId::asset_missing_field, field, "The field is missing.");
        return false;
    }
    if (from->size() != N) {
        fail(faults, FaultId::asset_wrong_length, field,
             "It has " + std::to_string(from->size()) + " values, not " + std::to_string(N) + ".");
        return false;
    }
    if (!check_alignment(from->Data(), alignof(double), field, faults)) return false;
    for (uint32_t i = 0; i < N; ++i) to[i] = from->Get(i);
    return true;
}

template <class T, class U>
void copy_vector(const flatbuffers::Vector<T>* from, std::vector<U>& to, const char* field, Faults& faults) {
    to.clear();
    if (!from || from->size() == 0 || !check_alignment(from->Data(), alignof(T), field, faults)) return;
    to.reserve(from->size());
    for (uint32_t i = 0; i < from->size(); ++i) to.push_back(from->Get(i));
}

std::string text(const flatbuffers::String* s) {
    return s ? s->str() : std::string();
}

template <class Need>
void decode_aerodynamics(const format::Aerodynamics& from, AerodynamicData& out, Faults& faults, const Need& need) {
    const auto vector = [&](const format::Vec3* v, const char* name, std::array<double, 3>& to) {
        if (need(v, name)) to = {v->x(), v->y(), v->z()};
    };
    copy_array(from.axes(), out.axes, "aerodynamics.axes", faults);
    vector(from.drag(), "aerodynamics.drag", out.drag);
    vector(from.drag_blunt(), "aerodynamics.drag_blunt", out.drag_blunt);
    vector(from.drag_layer(), "aerodynamics.drag_layer", out.drag_layer);
    vector(from.drag_stokes(), "aerodynamics.drag_stokes", out.drag_stokes);
    vector(from.lift(), "aerodynamics.lift", out.lift);
    vector(from.spin_lift(), "aerodynamics.spin_lift", out.spin_lift);
    vector(from.lift_moment(), "aerodynamics.lift_moment", out.lift_moment);
    vector(from.spin_drag(), "aerodynamics.spin_drag", out.spin_drag);
    vector(from.spin_drag_stream(), "aerodynamics.spin_drag_stream", out.spin_drag_stream);
    vector(from.spin_drag_stokes(), "aerodynamics.spin_drag_stokes", out.spin_drag_stokes);
    out.intensity = from.intensity();
    out.length = from.length();
    out.wake_reynolds = from.wake_reynolds();
    // Absent in files from before stall was modelled: then there is none.
    if (from.broadside()) vector(from.broadside(), "aerodynamics.broadside", out.broadside);
    out.lift_stall = from.lift_stall();
    if (from.lift_moment_stalled())
        vector(from.lift_moment_stalled(), "aerodynamics.lift_moment_stalled", out.lift_moment_stalled);
    if (from.roll_damping()) vector(from.roll_damping(), "aerodynamics.roll_damping", out.roll_damping);
    if (from.center()) vector(from.center(), "aerodynamics.center", out.center);
}

bool decode(const format::Asset& a, AssetData& out, Faults& faults) {
    const size_t before = faults.size();
    const auto need = [&](const void* field, const char* name, size_t alignment = alignof(double)) {
        if (!field) fail(faults, FaultId::asset_missing_field, name, "The field is missing.");
        return field && check_alignment(field, alignment, name, faults);
    };
    out.name = text(a.name());
    out.mass = a.mass();
    out.volume = a.volume();
    out.density = a.density();
    if (need(a.center_of_mass(), "center_of_mass"))
        out.center_of_mass = {a.center_of_mass()->x(), a.center_of_mass()->y(), a.center_of_mass()->z()};
    if (need(a.center_of_buoyancy(), "center_of_buoyancy"))
        out.center_of_buoyancy = {a.center_of_buoyancy()->x(), a.center_of_buoyancy()->y(),
                                  a.center_of_buoyancy()->z()};
    copy_array(a.inertia(), out.inertia, "inertia", faults);
    copy_array(a.added_mass(), out.added_mass, "added_mass", faults);
    if (a.added_mass_error()) copy_array(a.added_mass_error(), out.added_mass_error, "added_mass_error", faults);
    if (need(a.fluid(), "fluid")) {
        out.fluid_density = a.fluid()->density();
        out.fluid_viscosity = a.fluid()->viscosity();
    }
    if (need(a.lengths(), "lengths")) {
        out.length_d = a.lengths()->d();
        out.length_b = a.lengths()->b();
        out.length_l = a.lengths()->l();
    }
    out.projected_area = a.projected_area();
    out.u0 = a.u0();
    if (need(a.turbulence(), "turbulence", alignof(flatbuffers::soffset_t))) {
        const format::Turbulence& t = *a.turbulence();
        out.turbulence.dt = t.dt();
        copy_vector(t.chi(), out.turbulence.chi, "turbulence.chi", faults);
        copy_vector(t.epsilon(), out.turbulence.epsilon, "turbulence.epsilon", faults);
        out.turbulence.stationary = t.stationary();
        out.turbulence.c0 = t.c0();
        out.turbulence.intensity = t.intensity();
        if (t.cells() && t.cells()->size() == 3)
            for (uint32_t i = 0; i < 3; ++i) out.turbulence.cells[i] = t.cells()->Get(i);
        out.turbulence.loop_begin = t.loop_begin();
        out.turbulence.loop_end = t.loop_end();
        out.turbulence.wake = t.wake();
        out.turbulence.settled = t.settled();
        if (t.domain()) copy_array(t.domain(), out.turbulence.domain, "turbulence.domain", faults);
        out.turbulence.max_divergence = t.max_divergence();
    }
    out.has_aerodynamics = a.aerodynamics() && need(a.aerodynamics(), "aerodynamics", alignof(flatbuffers::soffset_t));
    if (out.has_aerodynamics) decode_aerodynamics(*a.aerodynamics(), out.aerodynamics, faults, need);
    if (a.hull()) {
        copy_vector(a.hull()->vertices(), out.hull.vertices, "hull.vertices", faults);
        copy_vector(a.hull()->triangles(), out.hull.triangles, "hull.triangles", faults);
    }
    if (a.provenance()) {
        const format::Provenance& p = *a.provenance();
        out.provenance = {text(p.tool()), text(p.tool_version()), text(p.source()),
                          p.input_hash(), text(p.options()),      p.faces(),
                          p.vertices()};
    }
    return faults.size() == before;
}

flatbuffers::Offset<format::Aerodynamics> encode(const AerodynamicData& a, flatbuffers::FlatBufferBuilder& b) {
    const auto vector = [](const std::array<double, 3>& v) { return format::Vec3(v[0], v[1], v[2]); };
    const auto axes = b.CreateVector(a.axes.data(), a.axes.size());
    const format::Vec3 drag = vector(a.drag), blunt = vector(a.drag_blunt), layer = vector(a.drag_layer);
    const format::Vec3 stokes = vector(a.drag_stokes), lift = vector(a.lift), spin_lift = vector(a.spin_lift);
    const format::Vec3 moment = vector(a.lift_moment), spin_drag = vector(a.spin_drag);
    const format::Vec3 spin_stream = vector(a.spin_drag_stream), spin_stokes = vector(a.spin_drag_stokes);
    const format::Vec3 broadside = vector(a.broadside), stalled = vector(a.lift_moment_stalled);
    const format::Vec3 roll = vector(a.roll_damping);
    const format::Vec3 center = vector(a.center);
    return format::CreateAerodynamics(b, axes, &drag, &blunt, &layer, &stokes, &lift, &spin_lift, &moment, &spin_drag,
                                      &spin_stream, &spin_stokes, a.intensity, a.length, a.wake_reynolds, &broadside,
                                      a.lift_stall, &stalled, &roll, &center);
}

} // namespace

std::vector<uint8_t> write_asset(const AssetData& d) {
    flatbuffers::FlatBufferBuilder b(4096);
    // Defaults are written too: a value that happens to be 0 must not look like a missing field.
    b.ForceDefaults(true);
    const auto name = b.CreateString(d.name);
    const auto inertia = b.CreateVector(d.inertia.data(), d.inertia.size());
    const auto added_mass = b.CreateVector(d.added_mass.data(), d.added_mass.size());
    const auto added_mass_error = b.CreateVector(d.added_mass_error.data(), d.added_mass_error.size());
    const auto turbulence = format::CreateTurbulence(
        b, d.turbulence.dt, b.CreateVector(d.turbulence.chi), b.CreateVector(d.turbulence.epsilon),
        d.turbulence.stationary, d.turbulence.c0, d.turbulence.intensity,
        b.CreateVector(d.turbulence.cells.data(), d.turbulence.cells.size()), d.turbulence.loop_begin,
        d.turbulence.loop_end, d.turbulence.wake, d.turbulence.settled,
        b.CreateVector(d.turbulence.domain.data(), d.turbulence.domain.size()), d.turbulence.max_divergence);
    const auto hull = format::CreateHull(b, b.CreateVector(d.hull.vertices), b.CreateVector(d.hull.triangles));
    const auto& p = d.provenance;
    const auto provenance =
        format::CreateProvenance(b, b.CreateString(p.tool), b.CreateString(p.tool_version), b.CreateString(p.source),
                                 p.input_hash, b.CreateString(p.options), p.faces, p.vertices);
    const auto aerodynamics =
        d.has_aerodynamics ? encode(d.aerodynamics, b) : flatbuffers::Offset<format::Aerodynamics>();
    const format::Vec3 com(d.center_of_mass[0], d.center_of_mass[1], d.center_of_mass[2]);
    const format::Vec3 cob(d.center_of_buoyancy[0], d.center_of_buoyancy[1], d.center_of_buoyancy[2]);
    const format::Fluid fluid(d.fluid_density, d.fluid_viscosity);
    const format::Lengths lengths(d.length_d, d.length_b, d.length_l);
    const auto root = format::CreateAsset(b, asset_format_version, 0, name, d.mass, d.volume, d.density, &com, &cob,
                                          inertia, added_mass, added_mass_error, &fluid, &lengths, d.projected_area,
                                          d.u0, turbulence, hull, provenance, aerodynamics);
    format::FinishAssetBuffer(b, root);

    std::vector<uint8_t> bytes(b.GetBufferPointer(), b.GetBufferPointer() + b.GetSize());
    const size_t at = checksum_offset(*format::GetAsset(bytes.data()), bytes.data());
    const uint64_t sum = checksum_without(bytes.data(), bytes.size(), at);
    for (size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<uint8_t>(sum >> (8 * i));
    return bytes;
}

bool read_asset(const void* bytes, size_t size, AssetData& out, Faults& faults) {
    if (size < 16) {
        fail(faults, FaultId::asset_too_short, "byte " + std::to_string(size), "The file ends before its header.");
        return false;
    }
    if (size > max_asset_bytes) {
        fail(faults, FaultId::file_too_large, "file", "An asset is at most 1 GiB.");
        return false;
    }
    // FlatBuffers wants alignment for 8-byte scalars; callers may have none.
    std::vector<uint64_t> aligned((size + 7) / 8);
    std::memcpy(aligned.data(), bytes, size);
    const auto* data = reinterpret_cast<const uint8_t*>(aligned.data());

    if (!format::AssetBufferHasIdentifier(data)) {
        fail(faults, FaultId::asset_foreign, "byte 4", "The identifier is not LRBA: this is not an asset file.",
             "Give a file that lr_bake made.");
        return false;
    }
    flatbuffers::Verifier verifier(data, size, 16, 10000);
    if (!format::VerifyAssetBuffer(verifier)) {
        fail(faults, FaultId::asset_corrupt, "structure", "The file is truncated or damaged.",
             "Copy it again from its source, or bake it again.");
        return false;
    }
    const format::Asset& asset = *format::GetAsset(data);
    if (asset.format_version() > asset_format_version) {
        fail(faults, FaultId::asset_newer_version, "format_version",
             "The file has format " + std::to_string(asset.format_version()) + ", this library reads up to " +
                 std::to_string(asset_format_version) + ".",
             "Update the library, or bake with the baker of this version.");
        return false;
    }
    const size_t at = checksum_offset(asset, data);
    if (asset.format_version() == 0 || at == 0) {
        fail(faults, FaultId::asset_missing_field, at == 0 ? "checksum" : "format_version", "The field is missing.");
        return false;
    }
    if (asset.checksum() != checksum_without(data, size, at)) {
        fail(faults, FaultId::asset_checksum, "checksum", "The bytes are not those that were written.",
             "Copy it again from its source, or bake it again.");
        return false;
    }
    return decode(asset, out, faults) && check_asset(out, faults) && check_plausible(out, faults);
}

} // namespace lr
