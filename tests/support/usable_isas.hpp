#ifndef SWIVEL_TESTS_SUPPORT_USABLE_ISAS_HPP
#define SWIVEL_TESTS_SUPPORT_USABLE_ISAS_HPP

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "swivel/isa.hpp"
#include "swivel/types.hpp"

namespace swivel::tests {

inline std::vector<isa> usable_isas() {
    std::vector<isa> usable;
    for (isa i : all_isas)
        if (is_usable(i)) usable.push_back(i);
    return usable;
}

// A test that runs once for each usable ISA, in one process.
class per_isa : public testing::TestWithParam<isa> {
protected:
    void SetUp() override { ASSERT_EQ(set_active_isa(GetParam()), status::ok); }
    void TearDown() override { ASSERT_EQ(set_active_isa(before_), status::ok); }

private:
    isa before_ = active_isa();
};

inline constexpr precision both_precisions[] = {precision::fast, precision::reproducible};

inline const char* name(precision p) { return p == precision::fast ? "fast" : "reproducible"; }

inline std::string isa_name(const testing::TestParamInfo<isa>& info) { return name(info.param); }

}  // namespace swivel::tests

#endif
