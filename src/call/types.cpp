#include "swivel/types.hpp"

#include "swivel/version.hpp"

namespace swivel {

const char* name(status s) noexcept {
    switch (s) {
        case status::ok:
            return "ok";
        case status::null_stream:
            return "a stream is null";
        case status::size_mismatch:
            return "the views differ in size";
        case status::partial_overlap:
            return "an output overlaps another stream";
        case status::bad_argument:
            return "an argument is out of range";
        case status::isa_unavailable:
            return "the ISA is not available";
    }
    return "unknown status";
}

const char* version() noexcept { return SWIVEL_VERSION; }

}  // namespace swivel
