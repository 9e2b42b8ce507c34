#ifndef SWIVEL_KERNELS_CONSTANTS_HPP
#define SWIVEL_KERNELS_CONSTANTS_HPP

// Numbers that the kernels and swivel::reference must share, because their results are equal in bits.

namespace swivel {
namespace {

template <class T>
struct constants;

template <>
struct constants<float> {
    // eps^2, options::default_pole_threshold.
    static constexpr float pole_threshold = 0x1p-48f;
    // Below this sum w^2 + u^2 the squares lose bits to underflow, whatever the threshold: 2^-126 of the
    // smallest normal number, and 24 bits and some to spare.
    static constexpr float pole_floor = 0x1p-100f;
    static constexpr float infinity = __builtin_inff();
    static constexpr float largest_power_of_two = 0x1p127f;

    // atan z = z + z^3 (c0 + c1 z^2 + ...) for |z| <= 1/2, relative error 5.4e-9 (minimax).
    static constexpr float atan[] = {-0x1.555512p-2f, 0x1.997b06p-3f, -0x1.2249b2p-3f, 0x1.9ffb90p-4f,
                                     -0x1.a3da52p-5f};
    // pi/4 in two parts; the first has so few bits that its product with 0..4 is exact.
    static constexpr float quarter_pi = 0x1.921fcp-1f;
    static constexpr float quarter_pi_rest = -0x1.5777a6p-22f;

    // sin r = r + r^3 (c0 + c1 r^2 + ...), cos r = 1 - r^2/2 + r^4 (c0 + c1 r^2 + ...) for |r| <= pi/4; relative errors
    // 4.0e-9 and 1.1e-10 (minimax).
    static constexpr float sin[] = {-0x1.555546p-3f, 0x1.110778p-7f, -0x1.9953f2p-13f};
    static constexpr float cos[] = {0x1.55554ap-5f, -0x1.6c0c1ap-10f, 0x1.99e0eep-16f};
    // The sum of the parts of pi/2, each but the last of 11 bits, so that products with whole numbers up to 2^13 are
    // exact: all that come with angles up to 2^13.
    static constexpr float half_pi[] = {0x1.92p0f, 0x1.fb4p-12f, 0x1.444p-24f, 0x1.68c234p-39f};
    static constexpr float largest_angle = 0x1p13f;
    static constexpr float two_over_pi = 0x1.45f306p-1f;
    // Added to a number up to 2^22, it leaves no room for a fraction.
    static constexpr float round = 0x1.8p23f;
    static constexpr float bit_0 = __builtin_bit_cast(float, 1U), bit_1 = __builtin_bit_cast(float, 2U);
};

template <>
struct constants<double> {
    static constexpr double pole_threshold = 0x1p-106;
    static constexpr double pole_floor = 0x1p-960;
    static constexpr double infinity = __builtin_inf();
    static constexpr double largest_power_of_two = 0x1p1023;

    // Relative error 4.1e-18.
    static constexpr double atan[] = {-0x1.5555555555516p-2, 0x1.999999999112bp-3,  -0x1.249249215d24cp-3,
                                      0x1.c71c70909b0f5p-4,  -0x1.745cf4c2c37b3p-4, 0x1.3b113d3390c9ep-4,
                                      -0x1.10f319312e880p-4, 0x1.dfe924e0a0fe3p-5,  -0x1.a396eb0a7ae0bp-5,
                                      0x1.56f1870d03915p-5,  -0x1.c171f08260df5p-6, 0x1.4b7053f40d89bp-7};
    static constexpr double quarter_pi = 0x1.921fb54442d20p-1;
    static constexpr double quarter_pi_rest = -0x1.ee59d9cceba40p-51;

    // Relative errors 3.7e-18 and 4.8e-20.
    static constexpr double sin[] = {-0x1.5555555555548p-3, 0x1.111111110f730p-7,   -0x1.a01a019be9213p-13,
                                     0x1.71de35552aeb6p-19, -0x1.ae5e4b8373053p-26, 0x1.5d8b556a87505p-33};
    static constexpr double cos[] = {0x1.555555555554cp-5,   -0x1.6c16c16c1521bp-10, 0x1.a01a019cbeb6ep-16,
                                     -0x1.27e4f812123d5p-22, 0x1.1ee9f0ccabf6dp-29,  -0x1.8fb0e1de41db5p-37};
    // 33 bits each, for whole numbers up to 2^20.
    static constexpr double half_pi[] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                         0x1.b839a252049c1p-104};
    static constexpr double largest_angle = 0x1p20;
    static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    static constexpr double round = 0x1.8p52;
    static constexpr double bit_0 = __builtin_bit_cast(double, 1ULL),
                            bit_1 = __builtin_bit_cast(double, 2ULL);
};

}  // namespace
}  // namespace swivel

#endif
