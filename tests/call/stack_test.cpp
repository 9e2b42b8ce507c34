// How much stack a call takes: any thread may call, those of small stacks too.

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <vector>

#include "support/operations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Stack : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Stack, testing::ValuesIn(usable_isas()), isa_name);

constexpr unsigned char unused = 0xa5;

template <class T>
struct run_of_all {
    const std::vector<operation<T>>* operations;
    std::vector<workspace<T>*> workspaces;
    bool failed = false;
};

template <class T>
void* run_all(void* data) {
    auto& run = *static_cast<run_of_all<T>*>(data);
    for (const operation<T>& op : *run.operations)
        for (workspace<T>* const w : run.workspaces)
            for (const precision p : both_precisions) run.failed |= op.run(*w, p) != status::ok;
    return nullptr;
}

// Bytes of its stack that a thread uses for all of them.
template <class T>
std::size_t used_by(run_of_all<T>& run) {
    constexpr std::size_t page = 4096;
    std::vector<unsigned char> memory(257 * page, unused);
    const std::size_t first = page - reinterpret_cast<std::uintptr_t>(memory.data()) % page;
    unsigned char* const stack = memory.data() + first;
    constexpr std::size_t size = 256 * page;
    pthread_attr_t attributes;
    pthread_t thread;
    EXPECT_EQ(pthread_attr_init(&attributes), 0);
    EXPECT_EQ(pthread_attr_setstack(&attributes, stack, size), 0);
    EXPECT_EQ(pthread_create(&thread, &attributes, run_all<T>, &run), 0);
    EXPECT_EQ(pthread_join(thread, nullptr), 0);
    pthread_attr_destroy(&attributes);
    return static_cast<std::size_t>(
        stack + size - std::find_if(stack, stack + size, [](unsigned char c) { return c != unused; }));
}

template <class T>
status do_nothing(const operations::settings&, const operations::block<const T>&,
                  const operations::block<T>&) {
    return status::ok;
}

template <class T>
void takes_no_more_than(std::size_t bytes) {
    workspace<T> contiguous(300, layout::soa), array(300, layout::aos_wxyz),
        strided(300, layout::every_other);
    generator g(3);
    for (workspace<T>* const w : {&contiguous, &array, &strided}) w->fill(g);
    // What is on it without any operation: the thread's own data and the way from here to the library.
    static const operations::operation idle{"nothing",
                                            "",
                                            "",
                                            {},
                                            [](const operations::settings&) { return operations::groups{}; },
                                            {do_nothing<float>, do_nothing<double>},
                                            {do_nothing<float>, do_nothing<double>}};
    const std::vector<operation<T>> nothing = {{"nothing", &idle, {}, {}, {}, {}}};
    run_of_all<T> way{&nothing, {&contiguous, &array, &strided}};
    const std::size_t without = used_by(way);
    for (const operation<T>& op : all_operations<T>()) {
        const std::vector<operation<T>> one = {op};
        run_of_all<T> run{&one, {&contiguous, &array, &strided}};
        const std::size_t with = used_by(run);
        EXPECT_FALSE(run.failed) << op.name;
        ASSERT_GT(with, without) << op.name;
        EXPECT_LE(with - without, bytes) << op.name;
    }
}

TEST_P(Stack, TakesAtMostSixteenKibibytes) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
    // Of src/ and of this test, by what they keep around every variable; the figure is that of the library as shipped.
    GTEST_SKIP() << "sanitizers widen frames";
#endif
#endif
    takes_no_more_than<float>(16 * 1024);
    takes_no_more_than<double>(16 * 1024);
}

}  // namespace
}  // namespace swivel::tests
