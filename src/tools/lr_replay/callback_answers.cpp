#include "tools/lr_replay/callback_answers.h"

#include "tools/lr_replay/replay_faults.h"

#include <bit>

namespace lr::replay {

void Answers::add(const unsigned char* data, size_t size) {
    recording::AnswerRecord header;
    const auto wrong = [] { throw Fault(FaultId::malformed, "a record's callback results have a wrong length"); };
    if (size < sizeof header) wrong();
    std::memcpy(&header, data, sizeof header);
    const auto rows = key_rows_ + static_cast<uint32_t>(std::popcount(header.given));
    if (header.given >> values_ != 0 || size - sizeof header != uint64_t{header.count} * rows * sizeof(float)) wrong();
    const unsigned char* const words = data + sizeof header;
    const auto at = [&](uint32_t row, uint32_t i) {
        uint32_t word;
        std::memcpy(&word, words + (size_t{row} * header.count + i) * sizeof word, sizeof word);
        return word;
    };
    for (uint32_t i = 0; i < header.count; ++i) {
        places_.emplace(Question{header.batch, at(0, i), at(1, i), at(2, i), key_rows_ > 3 ? at(3, i) : 0,
                                 std::bit_cast<uint64_t>(header.time)},
                        numbers_.size());
        for (uint32_t v = 0, row = key_rows_; v < values_; ++v)
            numbers_.push_back((header.given & 1u << v) != 0 ? std::bit_cast<float>(at(row++, i)) : 0.0f);
    }
}

bool Answers::find(uint32_t batch, double time, const float* const (&position)[3], uint32_t i, uint32_t given,
                   const float*& out) const {
    const auto bits = [&](size_t k) { return std::bit_cast<uint32_t>(position[k][i]); };
    const auto found = places_.find(Question{batch, bits(0), bits(1), bits(2), given, std::bit_cast<uint64_t>(time)});
    if (found == places_.end()) return false;
    out = numbers_.data() + found->second;
    return true;
}

// Calls take(i, numbers) for each position of the query with a recorded answer.
template <class Query, class Given, class Take>
void Answers::each(const Query& q, const Given& given, const Take& take) {
    const float* from = nullptr;
    for (uint32_t i = 0; i < q.count; ++i) {
        if (find(q.batch.id, q.time, q.position, i, given(i), from))
            take(i, from);
        else
            missed = true;
    }
}

void Answers::wind(void* self, const lr_wind_query* q) {
    static_cast<Answers*>(self)->each(
        *q, [](uint32_t) { return 0u; },
        [q](uint32_t i, const float* from) {
            for (size_t k = 0; k < 3; ++k) {
                q->velocity[k][i] = from[k];
                q->rate[k][i] = from[3 + k];
            }
            for (size_t k = 0; k < 9; ++k) q->gradient[k][i] = from[6 + k];
        });
}

void Answers::surface(void* self, const lr_water_query* q) {
    static_cast<Answers*>(self)->each(
        *q, [q](uint32_t i) { return recording::given_surface(*q, i); },
        [q](uint32_t i, const float* from) {
            q->height[i] = from[0];
            for (size_t k = 0; k < 3; ++k) {
                q->normal[k][i] = from[1 + k];
                q->velocity[k][i] = from[4 + k];
                q->rate[k][i] = from[7 + k];
            }
        });
}
} // namespace lr::replay
