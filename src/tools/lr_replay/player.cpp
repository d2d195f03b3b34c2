#include "tools/lr_replay/player.h"

#include "asset/asset.h"
#include "asset/asset_file.h"
#include "baker/fault_text.h"
#include "world/world.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace lr::replay {
namespace {

using recording::Kind;
using recording::Op;

// Limits the memory that a hostile recording can allocate.
struct Memory {
    uint64_t left;
    static void* allocate(void* user, uint64_t size, uint64_t alignment) {
        auto& self = *static_cast<Memory*>(user);
        if (size > self.left) return nullptr;
        void* const block =
            ::operator new(static_cast<size_t>(size), static_cast<std::align_val_t>(alignment), std::nothrow);
        if (block) self.left -= size;
        return block;
    }
    static void release(void* user, void* block, uint64_t size, uint64_t alignment) {
        static_cast<Memory*>(user)->left += size;
        ::operator delete(block, static_cast<std::align_val_t>(alignment));
    }
};

std::string hex(uint64_t v) {
    char text[24];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(v));
    return text;
}

template <class T> T front(const Record& r) {
    T value;
    if (r.size < sizeof value) Arguments::wrong("it is shorter than its kind requires");
    std::memcpy(&value, r.data, sizeof value);
    return value;
}

class Player {
public:
    Player(const unsigned char* bytes, size_t size, const Options& options)
        : options_(options), reader_(bytes, size), bytes_(bytes), size_(size), memory_{options.most_memory} {
        outcome_.library = reader_.library();
    }
    ~Player() {
        lr_world_destroy(scene_.world);
        for (lr_asset* asset : scene_.assets) lr_asset_release(asset);
    }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    Outcome run();

private:
    struct Pending { // a call whose result record has not been read
        bool any = false, cut = false, done = false;
        Op op = 0;
        Bytes arguments;
        lr_status status = LR_OK;
        uint64_t output = 0;
    };

    void make_world(const Record& r);
    void take_asset(const Record& r);
    void set_up(const Record& r);
    void fill_hole();
    void name_geometry(const Record& r);
    void begin(const Record& r);
    void take_call(const Record& r);
    void carry_out();
    bool compare(const recording::ResultRecord& r); // false on a difference
    void differ(const std::string& what) { outcome_.difference = {outcome_.calls, outcome_.steps, what}; }
    bool find_blob(uint64_t hash, Bytes& out);
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(scene_.world, &h);
        return h;
    }
    void write_place();
    void print_ids() const;

    const Options& options_;
    Reader reader_;
    const unsigned char* bytes_;
    size_t size_;
    Memory memory_;
    Scene scene_;
    Outcome outcome_;
    Pending call_;
    bool begun_ = false;
    std::vector<lr_batch> holes_;
    uint64_t set_up_ = 0; // output of the last setup call
    std::unordered_map<uint64_t, Reader::Place> blobs_;
    const FindBlob find_blob_ = [this](uint64_t hash, Bytes& out) { return find_blob(hash, out); };
};

bool Player::find_blob(uint64_t hash, Bytes& out) {
    const auto found = blobs_.find(hash);
    if (found == blobs_.end()) return false;
    Reader there(bytes_, size_);
    there.go(found->second);
    Record r;
    if (!there.next(r) || r.size < sizeof hash) return false;
    out.assign(r.data + sizeof hash, r.data + r.size);
    return true;
}

void Player::make_world(const Record& r) {
    if (scene_.world) Arguments::wrong("it is a second world");
    const auto from = front<recording::WorldRecord>(r);
    lr_world_desc d;
    lr_world_desc_init(&d, sizeof d);
    d.seed = from.seed;
    std::copy(from.gravity, from.gravity + 3, d.gravity);
    d.fluid_density = from.fluid_density;
    d.fluid_viscosity = from.fluid_viscosity;
    d.simd_target = options_.simd;
    d.worker_count = options_.workers;
    d.allocator = {&memory_, &Memory::allocate, &Memory::release};
    const lr_status status = lr_world_create(&d, &scene_.world);
    if (status != LR_OK) throw Fault(FaultId::world, std::string("no such world: ") + lr_status_string(status));
    scene_.wind.recorded = scene_.surface.recorded = (from.flags & LR_RECORD_CALLBACKS) != 0;
    outcome_.first_step = from.step_count;
}

void Player::take_asset(const Record& r) {
    const auto from = front<recording::AssetRecord>(r);
    if (from.id != scene_.assets.size()) Arguments::wrong("the assets are out of order");
    for (double e : from.extents)
        if (!(e >= 0.0 && e <= 1e4)) Arguments::wrong("the extents of an asset are not 0 to 1e4 m");
    AssetData data;
    Faults faults;
    if (!read_asset(r.data + sizeof from, r.size - sizeof from, data, faults))
        throw Fault(FaultId::asset, "asset " + std::to_string(from.id) + ": " +
                                        (faults.empty() ? std::string("refused") : to_string(faults.front())));
    auto asset = std::make_unique<lr_asset>(std::move(data), from.format,
                                            std::array<double, 3>{from.extents[0], from.extents[1], from.extents[2]});
    if (asset->content_hash != from.content_hash)
        throw Fault(FaultId::asset,
                    "asset " + std::to_string(from.id) + " has another hash here than in the recording");
    scene_.assets.push_back(asset.release());
}

// Occupies an empty batch slot until the snapshot is restored, so that later batches get their recorded slots.
void Player::fill_hole() {
    lr_ellipsoid_desc shape;
    lr_ellipsoid_desc_init(&shape, sizeof shape);
    shape.semi_axes[0] = shape.semi_axes[1] = shape.semi_axes[2] = 0.01;
    shape.density = 500.0;
    lr_asset* asset = nullptr;
    lr_batch_desc d;
    lr_batch_desc_init(&d, sizeof d);
    d.capacity = 1;
    lr_batch batch{};
    lr_status status = lr_asset_create_ellipsoid(&shape, &asset);
    d.asset = asset;
    if (status == LR_OK) status = lr_batch_create(scene_.world, &d, &batch);
    lr_asset_release(asset);
    if (status != LR_OK) throw Fault(FaultId::setup, std::string("an empty batch slot: ") + lr_status_string(status));
    holes_.push_back(batch);
}

void Player::set_up(const Record& r) {
    const auto op = front<Op>(r);
    if (r.size < 4 || !name_of(op)) throw Fault(FaultId::unknown_call, "a call of a newer library");
    if (op == recording::op_of("lr_world_snapshot_restore")) {
        for (lr_batch batch : holes_) lr_batch_destroy(scene_.world, batch);
        holes_.clear();
    }
    Arguments arguments(r.data + 4, r.size - 4, find_blob_, nullptr);
    const lr_status status = perform(op, arguments, scene_, set_up_);
    if (status != LR_OK) throw Fault(FaultId::setup, std::string(name_of(op)) + ": " + lr_status_string(status));
}

void Player::name_geometry(const Record& r) {
    uint32_t slot = 0;
    if (!scene_.world->colliders.find({set_up_}, slot)) Arguments::wrong("its geometry was not recorded");
    scene_.world->colliders.rename_shared(slot, front<uint64_t>(r));
}

void Player::begin(const Record& r) {
    if (begun_) Arguments::wrong("the recording begins twice");
    begun_ = true;
    if (front<uint64_t>(r) != hash())
        throw Fault(FaultId::other_beginning, "the hash of the initial state differs from the recorded one");
}

void Player::take_call(const Record& r) {
    call_ = {};
    call_.any = true;
    call_.op = front<Op>(r);
    if (!name_of(call_.op))
        throw Fault(FaultId::unknown_call, "a newer call, number " + std::to_string(front<uint16_t>(r)));
    if (r.size < 4) Arguments::wrong("it is shorter than its kind requires");
    uint16_t flags = 0;
    std::memcpy(&flags, r.data + 2, sizeof flags);
    call_.cut = (flags & recording::call_cut) != 0;
    call_.arguments.assign(r.data + 4, r.data + r.size);
    scene_.wind.clear();
    scene_.surface.clear();
    ++outcome_.calls;
}

void Player::carry_out() {
    if (!call_.any || call_.done) return;
    call_.done = true;
    std::ostringstream text;
    if (call_.cut) {
        ++outcome_.unread;
    } else {
        Arguments arguments(call_.arguments.data(), call_.arguments.size(), find_blob_,
                            options_.print ? &text : nullptr);
        call_.status = perform(call_.op, arguments, scene_, call_.output);
    }
    for (const auto& [answers, name] : {std::pair(&scene_.wind, "wind"), std::pair(&scene_.surface, "surface")})
        if (answers->missed && !answers->recorded)
            throw Fault(FaultId::callback, "step " + std::to_string(outcome_.steps + 1) + " needs the " + name +
                                               " callback: record with LR_RECORD_CALLBACKS");
    if (call_.op == recording::op_of("lr_world_step") && call_.status == LR_OK && !call_.cut) {
        ++outcome_.steps;
        write_place();
    }
    if (!options_.print) return;
    *options_.print << outcome_.calls << ' ' << name_of(call_.op) << '(' << (call_.cut ? "not recorded" : text.str())
                    << ") = ";
    if (call_.cut)
        *options_.print << "refused";
    else
        *options_.print << call_.status;
    if (scene_.made.size() > 1 && call_.status == LR_OK)
        print_ids();
    else if (call_.output != 0)
        *options_.print << ", 0x" << hex(call_.output);
    if (call_.op == recording::op_of("lr_world_step"))
        *options_.print << ", step " << outcome_.steps << ", hash " << hex(hash());
    *options_.print << '\n';
}

void Player::print_ids() const { // runs of them as "first to last"
    const std::vector<uint64_t>& ids = scene_.made;
    for (size_t from = 0, to = 0; from < ids.size(); from = to) {
        for (to = from + 1; to < ids.size() && ids[to] == ids[to - 1] + 1;) ++to;
        *options_.print << ", 0x" << hex(ids[from]);
        if (to > from + 1) *options_.print << " to 0x" << hex(ids[to - 1]);
    }
}

bool Player::compare(const recording::ResultRecord& r) {
    if (!call_.any || r.op != call_.op) Arguments::wrong("the result belongs to another call");
    // A call that ran out of memory changed nothing, and could succeed here, so it is skipped; lr_world_step still runs.
    call_.cut = call_.cut || (r.status == LR_ERROR_OUT_OF_MEMORY && call_.op != recording::op_of("lr_world_step"));
    carry_out();
    call_.any = false;
    const std::string name = name_of(call_.op);
    if (call_.cut) return true;
    if (r.status != call_.status) {
        differ(name + " returned " + std::to_string(r.status) + " (" + lr_status_string(r.status) + "), here " +
               std::to_string(call_.status) + " (" + lr_status_string(call_.status) + ")");
        return false;
    }
    const bool wandered = scene_.wind.missed || scene_.surface.missed;
    if (wandered) {
        differ("a callback is queried at positions that were not recorded");
        return false;
    }
    if (r.output != 0 && r.status == LR_OK && r.output != call_.output) {
        differ(name + " gave 0x" + hex(r.output) + ", here 0x" + hex(call_.output));
        return false;
    }
    if (r.hashed == 0) return true;
    const uint64_t here = hash();
    ++outcome_.hashes;
    if (here == r.hash) return true;
    differ("the world's hash was " + hex(r.hash) + ", here " + hex(here));
    return false;
}

void Player::write_place() {
    if (!options_.csv) return;
    lr_body_state s;
    lr_body_state_init(&s, sizeof s);
    *options_.csv << outcome_.steps;
    if (lr_body_get_state(scene_.world, options_.body, &s) == LR_OK) {
        outcome_.body = true;
        char text[160];
        std::snprintf(text, sizeof text, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", static_cast<double>(s.position[0]),
                      static_cast<double>(s.position[1]), static_cast<double>(s.position[2]),
                      static_cast<double>(s.orientation[0]), static_cast<double>(s.orientation[1]),
                      static_cast<double>(s.orientation[2]), static_cast<double>(s.orientation[3]));
        *options_.csv << text;
    } else {
        *options_.csv << ",,,,,,,";
    }
    *options_.csv << '\n';
}

Outcome Player::run() {
    if (options_.csv) *options_.csv << "step,x,y,z,qx,qy,qz,qw\n";
    Record r;
    for (Reader::Place at = reader_.place(); (outcome_.steps < options_.until || !begun_) && reader_.next(r);
         at = reader_.place()) {
        if (r.kind != Kind::world && !scene_.world) Arguments::wrong("it precedes the world's record");
        const bool early =
            r.kind == Kind::hole || r.kind == Kind::setup || r.kind == Kind::geometry || r.kind == Kind::begun;
        const bool any_time = r.kind == Kind::world || r.kind == Kind::asset || r.kind == Kind::blob;
        if (!any_time && early == begun_) Arguments::wrong("its kind is not allowed at this place");
        switch (r.kind) {
        case Kind::world:
            make_world(r);
            break;
        case Kind::asset:
            take_asset(r);
            break;
        case Kind::blob:
            blobs_[front<uint64_t>(r)] = at;
            break;
        case Kind::hole:
            fill_hole();
            break;
        case Kind::setup:
            set_up(r);
            break;
        case Kind::geometry:
            name_geometry(r);
            break;
        case Kind::begun:
            begin(r);
            break;
        case Kind::call:
            carry_out(); // a previous call without a result
            take_call(r);
            break;
        case Kind::wind:
            scene_.wind.add(r.data, r.size);
            break;
        case Kind::surface:
            scene_.surface.add(r.data, r.size);
            break;
        case Kind::result:
            if (!compare(front<recording::ResultRecord>(r))) return outcome_;
            break;
        default:
            Arguments::wrong("its kind is unknown");
        }
    }
    outcome_.cut = reader_.cut();
    if (!begun_) Arguments::wrong("the file ends before the initial state is complete");
    if (call_.any && outcome_.steps < options_.until) {
        // The missing end can include answers of its callbacks.
        outcome_.within = name_of(call_.op);
        carry_out();
    }
    outcome_.hash = hash();
    return outcome_;
}
} // namespace

Outcome play(const unsigned char* bytes, size_t size, const Options& options) {
    return Player(bytes, size, options).run();
}
} // namespace lr::replay
