#include "tools/lr_replay/recording_reader.h"

#include "tools/lr_replay/replay_faults.h"

#include <cstring>
#include <string>

namespace lr::replay {

Reader::Reader(const unsigned char* bytes, size_t size) : bytes_(bytes), size_(size) {
    recording::FileHeader header;
    if (size < sizeof header) throw Fault(FaultId::not_a_recording, "not a recording: the file is too short");
    std::memcpy(&header, bytes, sizeof header);
    if (std::memcmp(header.magic, recording::magic, sizeof header.magic) != 0)
        throw Fault(FaultId::not_a_recording, "not a recording: lr_world_record_start writes them");
    if (header.format != recording::format_version)
        throw Fault(FaultId::newer_format, "use another lr_replay: format " + std::to_string(header.format) +
                                               ", this program reads " + std::to_string(recording::format_version));
    library_ = header.library;
    at_ = sizeof header;
}

bool Reader::next(Record& out) {
    joined_.clear();
    for (bool begun = false;; begun = true) {
        recording::FrameHeader header;
        if (at_ == size_ && !begun) return false;
        cut_ = true; // until the record is complete
        if (size_ - at_ < sizeof header) return false;
        std::memcpy(&header, bytes_ + at_, sizeof header);
        const std::string where = "frame " + std::to_string(frame_) + " at byte " + std::to_string(at_);
        if (header.size > recording::most_frame - sizeof header || (header.flags & ~recording::frame_continues) != 0)
            throw Fault(FaultId::damaged, where + " is damaged");
        if (size_ - at_ - sizeof header < header.size) return false;
        const unsigned char* const payload = bytes_ + at_ + sizeof header;
        if (recording::frame_checksum(header, frame_, payload) != header.checksum)
            throw Fault(FaultId::damaged, where + " is damaged");
        const auto kind = static_cast<recording::Kind>(header.kind);
        if (begun && kind != out.kind) throw Fault(FaultId::damaged, where + " does not continue the frame before");
        out.kind = kind;
        at_ += sizeof header + header.size;
        ++frame_;
        const bool last = (header.flags & recording::frame_continues) == 0;
        if (!begun && last) { // one frame, as most records are: no copy
            out.data = payload;
            out.size = header.size;
            break;
        }
        joined_.insert(joined_.end(), payload, payload + header.size);
        if (last) {
            out.data = joined_.data();
            out.size = joined_.size();
            break;
        }
    }
    cut_ = false;
    return true;
}
} // namespace lr::replay
