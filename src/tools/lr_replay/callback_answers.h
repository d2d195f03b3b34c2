// Recorded answers of the wind and water callbacks, looked up by query.
#pragma once

#include "langevin_rigid.h"
#include "recording/recording_format.h"

#include <atomic>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

namespace lr::replay {

class Answers {
public:
    Answers(uint32_t key_rows, uint32_t values) : key_rows_(key_rows), values_(values) {}

    void clear() {
        places_.clear();
        numbers_.clear();
    }
    void add(const unsigned char* data, size_t size); // the payload of a record; throws Fault
    // The answer, `values` floats; false if the query was not recorded. Thread-safe while no answers are added.
    bool find(uint32_t batch, double time, const float* const (&position)[3], uint32_t i, uint32_t given,
              const float*& out) const;

    bool recorded = true;            // whether the recording has callback results
    std::atomic<bool> missed{false}; // whether any query was not recorded
    static void wind(void* self, const lr_wind_query* query);
    static void surface(void* self, const lr_water_query* query);

private:
    struct Question {
        uint32_t batch, x, y, z, given; // bits
        uint64_t time;
        bool operator==(const Question&) const = default;
    };
    struct HashOf {
        size_t operator()(const Question& q) const {
            recording::Hash hash(q.batch);
            hash.add(q.time);
            hash.add(q.x | uint64_t{q.y} << 32);
            hash.add(q.z | uint64_t{q.given} << 32);
            return static_cast<size_t>(hash.value());
        }
    };
    template <class Query, class Given, class Take> void each(const Query& q, const Given& given, const Take& take);

    uint32_t key_rows_, values_;
    std::unordered_map<Question, size_t, HashOf> places_;
    std::vector<float> numbers_;
};
} // namespace lr::replay
