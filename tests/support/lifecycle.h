// Rules and emitters for tests.
#pragma once

#include "support/scene.h"

namespace test {

inline lr_batch_rules rules_desc() {
    return initialised(lr_batch_rules_init);
}
inline lr_emitter_desc emitter_desc() {
    return initialised(lr_emitter_desc_init);
}
inline lr_batch_rules rules_with(const lr_kill_volume& v) {
    lr_batch_rules r = rules_desc();
    r.volume_count = 1;
    r.volumes[0] = v;
    return r;
}
inline void set_rules(const World& w, lr_batch batch, const lr_batch_rules& r) {
    REQUIRE(lr_batch_set_rules(w.get(), batch, &r) == LR_OK);
}
inline void set_emitter(const World& w, lr_batch batch, const lr_emitter_desc& d) {
    REQUIRE(lr_batch_set_emitter(w.get(), batch, &d) == LR_OK);
}
inline lr_batch_counts counts_of(const World& w, lr_batch batch) {
    lr_batch_counts e = initialised(lr_batch_counts_init);
    REQUIRE(lr_batch_get_counts(w.get(), batch, &e) == LR_OK);
    return e;
}
inline std::vector<lr_body> emit(const World& w, lr_batch batch, uint32_t count) {
    std::vector<lr_body> ids(count);
    REQUIRE(lr_batch_spawn(w.get(), batch, count, ids.data()) == LR_OK);
    return ids;
}

} // namespace test
