#include "world/snapshot_parts.h"

#include "world/lifecycle.h"
#include "world/snapshot_format.h"

#include <cmath>
#include <cstring>

namespace lr {
namespace {

constexpr uint64_t even(uint64_t words) {
    return even_words(words);
}
constexpr uint64_t record_words = sizeof(Lifecycle::Record) / 4;
// How a batch meets colliders.
struct SettingsRecord {
    uint32_t layers;
    float friction, restitution, rolling, ground_effect;
    uint32_t may_rest;
};
constexpr uint64_t settings_words = sizeof(SettingsRecord) / 4;
static_assert(sizeof(SettingsRecord) % 8 == 0);
constexpr uint64_t fault_words = sizeof(BodyFaults::Record) / 4;
constexpr uint64_t rest_words = sizeof(Resting::Record) / 4;
static_assert(sizeof(Lifecycle::Record) % 8 == 0 && force_components % 2 == 0);

ContactSettings settings_of(const SettingsRecord& r) {
    return {r.layers, r.friction, r.restitution, r.rolling, r.ground_effect, r.may_rest != 0};
}

uint32_t word_at(const unsigned char* from, uint64_t index) {
    uint32_t word;
    std::memcpy(&word, from + 4 * index, 4);
    return word;
}

// These loops run over all words, without branches: in vectors.
bool finite(const unsigned char* from, uint64_t words) {
    constexpr uint32_t exponent = 0x7f800000u;
    uint32_t bad = 0;
    for (uint64_t i = 0; i < words; ++i) bad |= (word_at(from, i) & exponent) == exponent ? 1u : 0u;
    return bad == 0;
}
// Of finite numbers: -0 is none.
bool negative(const unsigned char* from, uint64_t words) {
    uint32_t bad = 0;
    for (uint64_t i = 0; i < words; ++i) bad |= word_at(from, i) > 0x80000000u ? 1u : 0u;
    return bad != 0;
}

// Slots of colliders may be those of destroyed ones.
bool touched_consistent(uint32_t count, bool meets_bodies, const unsigned char* from) {
    const uint32_t most = meets_bodies ? 1 : 0;
    const uint64_t row = even(count);
    uint32_t bad = 0;
    static_assert(most_touched == 4);
    for (uint64_t i = 0; i < count; ++i) {
        const auto is_body = [&](uint64_t k) { return word_at(from, k * row + i) == touching_body ? 1u : 0u; };
        bad |= is_body(0) + is_body(1) + is_body(2) + is_body(3) > most ? 1u : 0u;
    }
    return bad == 0;
}

} // namespace

uint32_t parts_of(const Batch& batch) {
    const Lifecycle* const lifecycle = batch.lifecycle();
    return (batch.external.on_batch() ? part_batch_force : 0u) | (batch.external.pending() ? part_body_forces : 0u) |
           (lifecycle && lifecycle->in_use() ? part_lifecycle : 0u) | (batch.awake() < batch.count() ? part_rest : 0u) |
           (batch.resting() && batch.resting()->any_contact(batch.count()) ? part_contact : 0u) |
           (batch.contact == ContactSettings{} ? 0u : part_settings) | (batch.faults.in_use() ? part_faults : 0u);
}

// A birth for each body, of which those that move have none: so that the size depends on these two alone.
uint64_t part_column_words(uint32_t parts, uint32_t count, uint32_t column) {
    const auto next = [&](uint32_t columns) {
        if (column < columns) return true;
        column -= columns;
        return false;
    };
    if (next(1)) return parts & part_batch_force ? force_components : 0;
    if (next(force_components)) return parts & part_body_forces ? even(count) : 0;
    if (next(1)) return parts & part_lifecycle ? record_words : 0;
    if (next(1)) return parts & part_lifecycle ? even(count) : 0;
    if (next(1)) return parts & part_rest ? rest_words : 0;
    if (next(1)) return parts & part_rest ? 2 * uint64_t{count} : 0;
    if (next(1 + stay_rows + most_touched)) return parts & part_contact ? even(count) : 0;
    if (next(1)) return parts & part_settings ? settings_words : 0;
    return parts & part_faults ? fault_words : 0;
}

uint64_t parts_bytes(uint32_t parts, uint32_t count) {
    uint64_t words = 0;
    for (uint32_t column = 0; column < part_columns; ++column) words += part_column_words(parts, count, column);
    return 4 * words;
}

uint32_t rest_begin(uint32_t parts, uint32_t count, const unsigned char* from) {
    if (!(parts & part_rest)) return count;
    Resting::Record record;
    std::memcpy(&record, from + parts_bytes(parts & (part_rest - 1), count), sizeof record);
    return record.awake;
}

void save_parts(Batch& batch, uint32_t parts, unsigned char* to) {
    const uint32_t count = batch.count(), awake = batch.awake();
    const auto put = [&](const void* from, uint64_t words) {
        if (from && words != 0) std::memcpy(to, from, static_cast<size_t>(4 * words));
        std::memset(to + 4 * words, 0, static_cast<size_t>(4 * (even(words) - words)));
        to += 4 * even(words);
    };
    if (parts & part_batch_force) put(batch.external.batch(), force_components);
    if (parts & part_body_forces)
        for (size_t i = 0; i < force_components; ++i) put(batch.external.bodies() + i * batch.external.stride(), count);
    if (parts & part_lifecycle) {
        const Lifecycle::Record record = batch.lifecycle()->record();
        put(&record, record_words);
        put(batch.lifecycle()->lives(), count);
    }
    if (parts & part_rest) {
        const Resting::Record record = batch.resting()->record(batch.awake());
        put(&record, rest_words);
        std::memset(to, 0, uint64_t{8} * awake);
        to += uint64_t{8} * awake;
        put(batch.resting()->births() + awake, 2 * uint64_t{count - awake});
    }
    if (parts & part_contact) {
        const ContactArrays contact = batch.contact_arrays();
        put(contact.rest_time, count);
        for (const float* row : contact.stay) put(row, count);
        for (const uint32_t* touching : contact.touching) put(touching, count);
    }
    if (parts & part_settings) {
        const ContactSettings& s = batch.contact;
        const SettingsRecord record{s.layers,  s.friction,      s.restitution,
                                    s.rolling, s.ground_effect, s.may_rest ? 1u : 0u};
        put(&record, settings_words);
    }
    if (parts & part_faults) {
        const BodyFaults::Record record = batch.faults.record();
        put(&record, fault_words);
    }
}

bool parts_consistent(uint32_t parts, uint32_t count, bool meets_bodies, const unsigned char* from) {
    if (parts & part_batch_force) {
        float force[force_components];
        std::memcpy(force, from, sizeof force);
        if (wrong_batch_force(force)) return false;
        from += sizeof force;
    }
    if (parts & part_body_forces) {
        const uint64_t words = force_components * even(count);
        if (!finite(from, words)) return false;
        from += 4 * words;
    }
    if (parts & part_lifecycle) {
        Lifecycle::Record record;
        std::memcpy(&record, from, sizeof record);
        if (!Lifecycle::consistent(record)) return false;
        from += 4 * (record_words + even(count));
    }
    if (parts & part_rest) {
        Resting::Record record;
        std::memcpy(&record, from, sizeof record);
        if (!Resting::consistent(record, count)) return false;
        from += sizeof record;
        for (uint32_t i = 0; i < count; ++i, from += 8) {
            double birth;
            std::memcpy(&birth, from, 8);
            if (i >= record.awake && !Resting::consistent(record, birth)) return false;
        }
    }
    if (parts & part_contact) {
        // The two times, and how far it has gone since the second began.
        if (!finite(from, (1 + stay_rows) * even(count))) return false;
        if (negative(from, even(count) + count)) return false;
        from += uint64_t{4} * (1 + stay_rows) * even(count);
        if (!touched_consistent(count, meets_bodies, from)) return false;
        from += uint64_t{4} * most_touched * even(count);
    }
    if (parts & part_settings) {
        SettingsRecord record;
        std::memcpy(&record, from, sizeof record);
        if (record.may_rest > 1 || wrong_in(settings_of(record))) return false;
        from += sizeof record;
    }
    if (parts & part_faults) {
        BodyFaults::Record record;
        std::memcpy(&record, from, sizeof record);
        if (!BodyFaults::consistent(record)) return false;
    }
    return true;
}

bool reserve_parts(Batch& batch, uint32_t parts) {
    if ((parts & part_body_forces) && !batch.reserve_forces()) return false;
    // What a fault may end needs room for those that end.
    if ((parts & (part_lifecycle | part_faults)) && !batch.reserve_lifecycle()) return false;
    if ((parts & part_rest) && !batch.reserve_rest()) return false;
    return !(parts & part_contact) || batch.reserve_contact();
}

void restore_parts(Batch& batch, uint32_t parts, uint32_t count, uint32_t before, const unsigned char* from) {
    const auto get = [&](void* to, uint64_t words) {
        if (words != 0) std::memcpy(to, from, static_cast<size_t>(4 * words));
        from += 4 * even(words);
    };
    float force[force_components] = {};
    if (parts & part_batch_force) get(force, force_components);
    batch.external.set_batch(force);
    if (batch.external.pending()) batch.external.clear();
    if (parts & part_body_forces) {
        for (size_t i = 0; i < force_components; ++i) get(batch.external.bodies() + i * batch.external.stride(), count);
        batch.external.restored_pending();
    }
    if (Lifecycle* const lifecycle = batch.lifecycle()) {
        Lifecycle::Record record{};
        if (parts & part_lifecycle) get(&record, record_words);
        lifecycle->restore(record, parts & part_lifecycle ? count : 0);
        if (parts & part_lifecycle) get(lifecycle->lives(), count);
    }
    batch.restore_rest(parts & part_rest ? from : nullptr, before);
    if (parts & part_rest) from += 4 * rest_words + 8 * uint64_t{count};
    const ContactArrays contact = batch.contact_arrays();
    if ((parts & part_contact) && contact.rest_time) { // they have been reserved
        get(contact.rest_time, count);
        for (float* row : contact.stay) get(row, count);
        for (uint32_t* touching : contact.touching) get(touching, count);
    }
    batch.contact = {};
    if (parts & part_settings) {
        SettingsRecord record;
        get(&record, settings_words);
        batch.contact = settings_of(record);
    }
    BodyFaults::Record faults{};
    if (parts & part_faults) get(&faults, fault_words);
    batch.faults.restore(faults);
}

} // namespace lr
