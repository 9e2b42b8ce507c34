// What is refused, with nothing written; what is allowed although streams touch.

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <limits>

#include "support/operations.hpp"
#include "support/usable_isas.hpp"

namespace swivel::tests {
namespace {

class Checks : public per_isa {};
INSTANTIATE_TEST_SUITE_P(Isa, Checks, testing::ValuesIn(usable_isas()), isa_name);

constexpr std::size_t n = 37;

struct arena {
    std::vector<float> memory = std::vector<float>(64 * n, untouched<float>);
    float* at(std::size_t offset) { return memory.data() + offset; }
    quat_view<float> four(std::size_t offset) {
        return soa(at(offset), at(offset + n), at(offset + 2 * n), at(offset + 3 * n), n);
    }
    bool is_untouched() const {
        return std::all_of(memory.begin(), memory.end(), [](float v) { return v == untouched<float>; });
    }
};

TEST_P(Checks, NullStreamIsRefusedWithNothingWritten) {
    arena a;
    const quat_view<float> q = a.four(0), s = a.four(4 * n), t = a.four(8 * n);
    for (int component = 0; component < 12; ++component) {
        quat_view<float> views[3] = {q, s, t};
        float** pointers[4] = {&views[component / 4].x, &views[component / 4].y, &views[component / 4].z,
                               &views[component / 4].w};
        *pointers[component % 4] = nullptr;
        EXPECT_EQ(decompose(views[0], axis::z, views[1], views[2]), status::null_stream) << component;
    }
    EXPECT_EQ(twist_angle(q, axis::z, scalar_view<float>{nullptr, n}), status::null_stream);
    EXPECT_EQ(
        decompose(q, axis::z, factor_view<float>{a.at(900), nullptr, a.at(1000), a.at(1100), a.at(1200), n}),
        status::null_stream);
    EXPECT_EQ(decompose(q, vec3_view<const float>{a.at(0), nullptr, a.at(1), n}, s, t), status::null_stream);
    EXPECT_EQ(decompose(q, axis::z, s, t, scalar_view<float>{nullptr, n}, {}), status::null_stream);
    EXPECT_EQ(compose(aos_xyzw<const float>(nullptr, n), t, q), status::null_stream);
    EXPECT_TRUE(a.is_untouched());
}

TEST_P(Checks, SizesThatDifferAreRefusedWithNothingWritten) {
    arena a;
    quat_view<float> q = a.four(0), s = a.four(4 * n), t = a.four(8 * n);
    t.size = n - 1;
    EXPECT_EQ(decompose(q, axis::z, s, t), status::size_mismatch);
    t.size = 0;
    EXPECT_EQ(decompose(q, axis::z, s, t), status::size_mismatch);
    t.size = n;
    EXPECT_EQ(decompose(q, vec3_view<const float>{a.at(0), a.at(1), a.at(2), n - 1, 1}, s, t),
              status::size_mismatch);
    EXPECT_EQ(twist_angle(q, axis::z, scalar_view<float>{a.at(900), n + 1}), status::size_mismatch);
    EXPECT_TRUE(a.is_untouched());
}

TEST_P(Checks, PartialOverlapIsRefusedWithNothingWritten) {
    arena a;
    const quat_view<float> q = a.four(0), s = a.four(4 * n), t = a.four(8 * n);
    for (std::size_t shift : {std::size_t{1}, n / 2, n - 1}) {
        // Of an output with an input, in either direction, and of one output with another.
        EXPECT_EQ(decompose(q, axis::z, a.four(shift), t), status::partial_overlap);
        EXPECT_EQ(decompose(a.four(shift), axis::z, q, t), status::partial_overlap);
        EXPECT_EQ(decompose(q, axis::z, s, a.four(4 * n + shift)), status::partial_overlap);
    }
    EXPECT_EQ(decompose(q, axis::z, s, s), status::partial_overlap);
    // Two components of one output.
    EXPECT_EQ(decompose(q, axis::z, soa(s.x, s.x, s.z, s.w, n), t), status::partial_overlap);
    EXPECT_EQ(decompose(q, axis::z, soa(s.x, s.x + 1, s.z, s.w, n), t), status::partial_overlap);
    // An array of quaternions over its own middle, and one that begins a component late.
    float* array = a.at(20 * n);
    EXPECT_EQ(twist(aos_xyzw(array, n), axis::z, aos_xyzw(array + 4, n)), status::partial_overlap);
    EXPECT_EQ(twist(aos_xyzw(array, n), axis::z, aos_xyzw(array + 1, n)), status::partial_overlap);
    EXPECT_EQ(twist(aos_xyzw(array, n), axis::z, soa(array, array + n, array + 2 * n, array + 3 * n, n)),
              status::partial_overlap);
    EXPECT_EQ(twist_angle(q, axis::z, scalar_view<float>{q.y + 3, n}), status::partial_overlap);
    EXPECT_EQ(decompose(q, vec3_view<const float>{s.x, s.y, s.z + 1, n, 1}, s, t), status::partial_overlap);
    // A quaternion that all elements share may not be written over.
    EXPECT_EQ(twist(quat_view<const float>{q.x, q.y, q.z, q.w, n, 0}, axis::z, q), status::partial_overlap);
    EXPECT_TRUE(a.is_untouched());
}

TEST_P(Checks, BadArgumentIsRefusedWithNothingWritten) {
    arena a;
    const quat_view<float> q = a.four(0), s = a.four(4 * n), t = a.four(8 * n);
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    for (const vec3<float>& axis_for_all :
         {vec3<float>{0, 0, 0}, vec3<float>{-0.0f, 0, -0.0f}, vec3<float>{nan, 0, 1}, vec3<float>{0, inf, 0},
          vec3<float>{1, 1, -inf}, vec3<float>{inf, nan, 0}}) {
        EXPECT_EQ(decompose(q, axis_for_all, s, t), status::bad_argument);
        EXPECT_EQ(reference::decompose(q, axis_for_all, s, t), status::bad_argument);
    }
    EXPECT_EQ(decompose(q, static_cast<axis>(3), s, t), status::bad_argument);
    EXPECT_EQ(decompose(q, static_cast<axis>(255), s, t), status::bad_argument);
    EXPECT_EQ(decompose(q, axis::x, s, t, {.order = static_cast<product>(2)}), status::bad_argument);
    EXPECT_EQ(decompose(q, axis::x, s, t, {.accuracy = static_cast<precision>(2)}), status::bad_argument);
    for (double threshold : {-0.5, 1.5, double(nan), double(inf), -double(inf)})
        EXPECT_EQ(decompose(q, axis::x, s, t, {.pole_threshold = threshold}), status::bad_argument)
            << threshold;
    EXPECT_EQ(compose(s, t, q, {.order = static_cast<product>(9)}), status::bad_argument);
    // An output of stride 0, and views that are larger than memory.
    EXPECT_EQ(twist(q, axis::x, quat_view<float>{s.x, s.y, s.z, s.w, n, 0}), status::bad_argument);
    const std::ptrdiff_t most = std::numeric_limits<std::ptrdiff_t>::max(),
                         least = std::numeric_limits<std::ptrdiff_t>::min();
    for (std::ptrdiff_t stride : {most, least, most / 8, least / 8})
        EXPECT_EQ(twist(quat_view<const float>{q.x, q.y, q.z, q.w, n, stride}, axis::x, s),
                  status::bad_argument)
            << stride;
    const std::size_t huge = std::numeric_limits<std::size_t>::max();
    EXPECT_EQ(twist(soa(q.x, q.y, q.z, q.w, huge), axis::x, soa(s.x, s.y, s.z, s.w, huge)),
              status::bad_argument);
    EXPECT_EQ(twist(soa(q.x, q.y, q.z, q.w, huge / 4), axis::x, soa(s.x, s.y, s.z, s.w, huge / 4)),
              status::bad_argument);
    EXPECT_TRUE(a.is_untouched());
}

TEST_P(Checks, AxisOfAnyLengthIsAccepted) {
    const float lengths[] = {
        std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::min(), 1e-30f, 1.0f, 1e30f,
        std::numeric_limits<float>::max()};
    for (float length : lengths) {
        quat_buffer<float> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
        q.set(0, {0.5f, 0.5f, 0.5f, 0.5f});
        ASSERT_EQ(decompose(q.view(), vec3<float>{0, length, 0}, s.view(), t.view()), status::ok);
        EXPECT_NEAR(t.get(0).y, std::sqrt(0.5), 1e-6) << length;
    }
    const double wide_lengths[] = {std::numeric_limits<double>::denorm_min(), 1e-300, 1e300,
                                   std::numeric_limits<double>::max()};
    for (double length : wide_lengths) {
        quat_buffer<double> q(1, layout::soa), s(1, layout::soa), t(1, layout::soa);
        q.set(0, {0.5, 0.5, 0.5, 0.5});
        ASSERT_EQ(decompose(q.view(), vec3<double>{length, length, 0}, s.view(), t.view()), status::ok);
        EXPECT_NEAR(t.get(0).x, t.get(0).y, 1e-15) << length;
        EXPECT_NEAR(t.get(0).z, 0, 1e-15) << length;
    }
}

template <class T>
void in_place() {
    for (layout l : all_layouts)
        for (std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{67}, std::size_t{1000}})
            for (product order : {product::swing_twist, product::twist_swing})
                for (precision p : {precision::fast, precision::reproducible}) {
                    const options o{.order = order, .accuracy = p};
                    generator g(31);
                    quat_buffer<T> q(size, l), s(size, l), t(size, l), q2(size, l), t2(size, l);
                    vec3_buffer<T> axes(size, l), axes2(size, l);
                    for (std::size_t i = 0; i < size; ++i) {
                        const quat<T> r = random_rotation<T>(g);
                        q.set(i, r);
                        q2.set(i, r);
                        const vec3<T> a = random_direction<T>(g);
                        axes.set(i, a);
                        axes2.set(i, a);
                    }
                    // The swing over q; the twist elsewhere.
                    ASSERT_EQ(decompose(q.view(), axes.view(), s.view(), t.view(), o), status::ok);
                    ASSERT_EQ(decompose(q2.view(), axes2.view(), q2.view(), t2.view(), o), status::ok)
                        << name(l);
                    for (std::size_t i = 0; i < size; ++i) {
                        ASSERT_EQ(q2.get(i), s.get(i));
                        ASSERT_EQ(t2.get(i), t.get(i));
                    }
                    // The product over the twist.
                    quat_buffer<T> product_of(size, l);
                    ASSERT_EQ(compose(s.view(), t.view(), product_of.view(), o), status::ok);
                    ASSERT_EQ(compose(s.view(), t2.view(), t2.view(), o), status::ok);
                    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(t2.get(i), product_of.get(i));
                    // The angle over one component.
                    quat_buffer<T> q3(size, l);
                    scalar_buffer<T> angle(size, layout::soa);
                    for (std::size_t i = 0; i < size; ++i) q3.set(i, q.get(i));
                    ASSERT_EQ(twist_angle(q.view(), axis::y, angle.view(), o), status::ok);
                    ASSERT_EQ(
                        twist_angle(q3.view(), axis::y, scalar_view<T>{q3.first(2), size, q3.stride()}, o),
                        status::ok);
                    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(q3.at(2, i), angle[i]);
                }
}

TEST_P(Checks, InPlaceGivesTheSameBits) {
    in_place<float>();
    in_place<double>();
}

TEST_P(Checks, StreamsMayBePairedInAnyOrderInPlace) {
    arena a;
    generator g(37);
    const quat_view<float> q = a.four(0), t = a.four(4 * n), want = a.four(8 * n), want_t = a.four(12 * n);
    for (std::size_t i = 0; i < n; ++i) {
        const quat<float> r = random_rotation<float>(g);
        q.x[i] = r.x, q.y[i] = r.y, q.z[i] = r.z, q.w[i] = r.w;
    }
    ASSERT_EQ(decompose(q, axis::y, want, want_t), status::ok);
    ASSERT_EQ(decompose(q, axis::y, soa(q.w, q.x, q.y, q.z, n), t), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        ASSERT_EQ(q.w[i], want.x[i]);
        ASSERT_EQ(q.x[i], want.y[i]);
        ASSERT_EQ(q.y[i], want.z[i]);
        ASSERT_EQ(q.z[i], want.w[i]);
    }
}

TEST_P(Checks, InterleavedRecordsDoNotCountAsOverlap) {
    // Records of 12 numbers: q, swing, twist side by side.
    constexpr std::size_t record = 12;
    std::vector<double> memory(record * n, untouched<double>);
    generator g(41);
    const auto field = [&](std::size_t at) {
        double* p = memory.data() + at;
        return quat_view<double>{p, p + 1, p + 2, p + 3, n, record};
    };
    for (std::size_t i = 0; i < n; ++i) {
        const quat<double> r = random_rotation<double>(g);
        double* p = memory.data() + record * i;
        p[0] = r.x, p[1] = r.y, p[2] = r.z, p[3] = r.w;
    }
    quat_buffer<double> s(n, layout::soa), t(n, layout::soa);
    ASSERT_EQ(decompose(field(0), axis::x, field(4), field(8)), status::ok);
    ASSERT_EQ(decompose(field(0), axis::x, s.view(), t.view()), status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        const double* p = memory.data() + record * i;
        ASSERT_EQ((quat<double>{p[4], p[5], p[6], p[7]}), s.get(i));
        ASSERT_EQ((quat<double>{p[8], p[9], p[10], p[11]}), t.get(i));
    }
    // The same array read backwards is not the same elements.
    EXPECT_EQ(twist(field(0), axis::x,
                    quat_view<double>{&memory[record * (n - 1)], &memory[record * (n - 1) + 1],
                                      &memory[record * (n - 1) + 2], &memory[record * (n - 1) + 3], n,
                                      -static_cast<std::ptrdiff_t>(record)}),
              status::partial_overlap);
}

TEST_P(Checks, StrideZeroReadsOneElementForAll) {
    quat_buffer<float> q(1, layout::soa), s(n, layout::soa), t(n, layout::soa);
    q.set(0, {0.5f, -0.5f, 0.5f, 0.5f});
    ASSERT_EQ(decompose(quat_view<const float>{q.first(0), q.first(1), q.first(2), q.first(3), n, 0}, axis::z,
                        s.view(), t.view()),
              status::ok);
    for (std::size_t i = 0; i < n; ++i) {
        ASSERT_EQ(s.get(i), s.get(0));
        ASSERT_EQ(t.get(i), t.get(0));
    }
    EXPECT_NEAR(t.get(0).z, std::sqrt(0.5f), 1e-6);
}

// Memory that ends at a page which can be neither read nor written.
template <class T>
class guarded {
public:
    explicit guarded(std::size_t count) {
        const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        pages_ = (count * sizeof(T) + page - 1) / page * page + page;
        base_ = mmap(nullptr, pages_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (base_ == MAP_FAILED) throw std::bad_alloc();
        char* end = static_cast<char*>(base_) + pages_ - page;
        mprotect(end, page, PROT_NONE);
        first_ = reinterpret_cast<T*>(end) - count;
    }
    ~guarded() { munmap(base_, pages_); }
    guarded(const guarded&) = delete;
    guarded& operator=(const guarded&) = delete;
    T* first() { return first_; }

private:
    std::size_t pages_;
    void* base_;
    T* first_;
};

template <class T>
void touches_nothing_past_the_end() {
    generator g(43);
    for (std::size_t size = 1; size <= 65; ++size) {
        std::vector<std::unique_ptr<guarded<T>>> streams;
        for (int k = 0; k < 12; ++k) streams.push_back(std::make_unique<guarded<T>>(size));
        const auto at = [&](std::size_t k) { return streams[k]->first(); };
        const auto four = [&](std::size_t k) { return soa(at(k), at(k + 1), at(k + 2), at(k + 3), size); };
        guarded<T> in(4 * size), out(4 * size), axes(3 * size);
        for (std::size_t i = 0; i < size; ++i) {
            const quat<T> r = random_rotation<T>(g);
            at(0)[i] = r.x, at(1)[i] = r.y, at(2)[i] = r.z, at(3)[i] = r.w;
            for (std::size_t c = 0; c < 4; ++c) in.first()[4 * i + c] = at(c)[i];
            for (std::size_t c = 0; c < 3; ++c) axes.first()[3 * i + c] = T(c + 1);
        }
        const factor_view<T> factors{at(4), at(5), at(6), at(7), at(8), size};
        for (precision p : {precision::fast, precision::reproducible}) {
            const options o{.accuracy = p};
            ASSERT_EQ(decompose(four(0), axis::z, four(4), four(8), o), status::ok);
            ASSERT_EQ(decompose(four(0), vec3<T>{1, 2, 3}, four(4), four(8), o), status::ok);
            ASSERT_EQ(decompose(four(0), aos_xyz<const T>(axes.first(), size), four(4), four(8), o),
                      status::ok);
            ASSERT_EQ(decompose(four(0), axis::z, factors, scalar_view<T>{at(9), size}, o), status::ok);
            ASSERT_EQ(
                compose(factors, axis::z, scalar_view<const T>{at(9), size}, aos_wxyz(out.first(), size), o),
                status::ok);
            ASSERT_EQ(compose(four(4), four(8), aos_xyzw(out.first(), size), o), status::ok);
            ASSERT_EQ(swing(aos_xyzw(in.first(), size), axis::x, aos_wxyz(out.first(), size), o), status::ok);
            ASSERT_EQ(twist(aos_wxyz(in.first(), size), axis::x, aos_xyzw(out.first(), size), o), status::ok);
            ASSERT_EQ(twist_angle(aos_xyzw(in.first(), size), axis::x, scalar_view<T>{at(9), size}, o),
                      status::ok);
        }
    }
}

TEST_P(Checks, TouchesNothingPastTheEnd) {
    touches_nothing_past_the_end<float>();
    touches_nothing_past_the_end<double>();
}

// Nor before the beginning, nor between the elements of a strided view.
TEST_P(Checks, WritesNothingBetweenElements) {
    for (const operation<float>& op : all_operations<float>())
        for (layout l : all_layouts) {
            workspace<float> w(n, l);
            generator g(47);
            w.fill(g);
            ASSERT_EQ(op.run(w, precision::fast), status::ok);
            for (any_buffer<float>* b : op.writes(w)) {
                std::size_t written = 0;
                for (float v : b->memory()) written += v != untouched<float>;
                ASSERT_EQ(written, static_cast<std::size_t>(b->components()) * n)
                    << op.name << ' ' << name(l);
            }
        }
}

TEST_P(Checks, HugeSizesRun) {
    constexpr std::size_t huge = (std::size_t{1} << 22) + 3;
    std::vector<float> memory(8 * huge);
    const auto at = [&](std::size_t k) { return memory.data() + k * huge; };
    for (std::size_t i = 0; i < huge; ++i) at(3)[i] = 0.6f, at(2)[i] = i % 2 != 0 ? 0.8f : -0.8f;
    ASSERT_EQ(twist(soa(at(0), at(1), at(2), at(3), huge), axis::z, soa(at(4), at(5), at(6), at(7), huge)),
              status::ok);
    for (std::size_t i = huge - 40; i < huge; ++i) ASSERT_NEAR(at(6)[i], i % 2 != 0 ? 0.8f : -0.8f, 1e-6f);
}

}  // namespace
}  // namespace swivel::tests
