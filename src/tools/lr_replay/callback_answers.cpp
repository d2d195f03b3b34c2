#include "tools/lr_replay/callback_answers.h"

#include "tools/lr_replay/replay_faults.h"

#include <bit>

namespace lr::replay {

Answers::Question Answers::question(uint32_t batch, double time, float x, float y, float z) {
    return {batch, std::bit_cast<uint32_t>(x), std::bit_cast<uint32_t>(y), std::bit_cast<uint32_t>(z),
            std::bit_cast<uint64_t>(time)};
}

void Answers::add(const unsigned char* data, size_t size) {
    recording::AnswerRecord header;
    const auto wrong = [] { throw Fault(FaultId::malformed, "a record's callback results have a wrong length"); };
    if (size < sizeof header) wrong();
    std::memcpy(&header, data, sizeof header);
    const auto rows = 3 + static_cast<uint32_t>(std::popcount(header.given));
    if (header.given >> values_ != 0 || size - sizeof header != uint64_t{header.count} * rows * sizeof(float)) wrong();
    const unsigned char* const floats = data + sizeof header;
    const auto at = [&](uint32_t row, uint32_t i) {
        float v;
        std::memcpy(&v, floats + (size_t{row} * header.count + i) * sizeof v, sizeof v);
        return v;
    };
    for (uint32_t i = 0; i < header.count; ++i) {
        places_.emplace(question(header.batch, header.time, at(0, i), at(1, i), at(2, i)), numbers_.size());
        for (uint32_t v = 0, row = 3; v < values_; ++v)
            numbers_.push_back((header.given & 1u << v) != 0 ? at(row++, i) : 0.0f);
    }
}

bool Answers::find(uint32_t batch, double time, float x, float y, float z, const float*& out) const {
    const auto found = places_.find(question(batch, time, x, y, z));
    if (found == places_.end()) return false;
    out = numbers_.data() + found->second;
    return true;
}

// Calls take(i, numbers) for each position of the query with a recorded answer.
template <class Query, class Take> void Answers::each(const Query& q, const Take& take) {
    const float* from = nullptr;
    for (uint32_t i = 0; i < q.count; ++i) {
        if (find(q.batch.id, q.time, q.position[0][i], q.position[1][i], q.position[2][i], from))
            take(i, from);
        else
            missed = true;
    }
}

void Answers::wind(void* self, const lr_wind_query* q) {
    static_cast<Answers*>(self)->each(*q, [q](uint32_t i, const float* from) {
        for (size_t k = 0; k < 3; ++k) {
            q->velocity[k][i] = from[k];
            q->rate[k][i] = from[3 + k];
        }
        for (size_t k = 0; k < 9; ++k) q->gradient[k][i] = from[6 + k];
    });
}

void Answers::surface(void* self, const lr_water_query* q) {
    static_cast<Answers*>(self)->each(*q, [q](uint32_t i, const float* from) {
        q->height[i] = from[0];
        for (size_t k = 0; k < 3; ++k) {
            q->normal[k][i] = from[1 + k];
            q->velocity[k][i] = from[4 + k];
            q->rate[k][i] = from[7 + k];
        }
    });
}
} // namespace lr::replay
