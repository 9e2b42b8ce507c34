#include "swivel/isa.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

TEST(Isa, ActiveOneIsUsable) { EXPECT_TRUE(is_usable(active_isa())); }

TEST(Isa, UsableImpliesCompiled) {
    for (isa i : usable_isas()) EXPECT_TRUE(is_compiled(i)) << name(i);
}

TEST(Isa, SelectingAnUnusableOneChangesNothing) {
    const isa before = active_isa();
    for (isa i : all_isas) {
        if (is_usable(i)) continue;
        EXPECT_EQ(set_active_isa(i), status::isa_unavailable) << name(i);
    }
    EXPECT_EQ(set_active_isa(static_cast<isa>(200)), status::isa_unavailable);
    EXPECT_EQ(active_isa(), before);
    EXPECT_STREQ(name(static_cast<isa>(200)), "unknown");
}

TEST(Isa, SelectingIsSeenAtOnce) {
    const isa before = active_isa();
    for (isa i : usable_isas()) {
        ASSERT_EQ(set_active_isa(i), status::ok);
        EXPECT_EQ(active_isa(), i);
    }
    ASSERT_EQ(set_active_isa(before), status::ok);
}

TEST(Isa, NamesAreDistinct) {
    for (isa a : all_isas)
        for (isa b : all_isas) EXPECT_EQ(std::strcmp(name(a), name(b)) == 0, a == b);
}

TEST(Isa, BaselineIsAlwaysUsable) {
#if defined(__x86_64__)
    EXPECT_TRUE(is_usable(isa::sse2));
    EXPECT_FALSE(is_compiled(isa::neon64));
#elif defined(__aarch64__)
    EXPECT_TRUE(is_usable(isa::neon64));
    EXPECT_FALSE(is_compiled(isa::sse2));
#endif
}

TEST(Isa, SelectingFromManyThreadsLeavesOneOfThem) {
    const isa before = active_isa();
    const std::vector<isa> usable = usable_isas();
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&usable, t] {
            for (std::size_t k = 0; k < 1000; ++k)
                (void)set_active_isa(usable[(k + static_cast<std::size_t>(t)) % usable.size()]);
        });
    for (std::thread& t : threads) t.join();
    EXPECT_TRUE(is_usable(active_isa()));
    ASSERT_EQ(set_active_isa(before), status::ok);
}

TEST(Status, EveryOneHasWords) {
    for (int s = 0; s <= static_cast<int>(status::isa_unavailable); ++s)
        EXPECT_STRNE(name(static_cast<status>(s)), "unknown status");
    EXPECT_STREQ(name(static_cast<status>(77)), "unknown status");
}

}  // namespace
}  // namespace swivel::tests
