#ifndef SWIVEL_KERNELS_CONSTANTS_HPP
#define SWIVEL_KERNELS_CONSTANTS_HPP

// Numbers that the kernels and swivel::reference must share, because their results are equal in bits.

namespace swivel {
namespace {

template <class T>
struct constants;

template <>
struct constants<float> {
    static constexpr float rounding = 0x1p-24f;
    // Its square, options::default_pole_threshold.
    static constexpr float pole_threshold = 0x1p-48f;
    // Below this sum w^2 + u^2 the squares lose bits to underflow, whatever the threshold: 2^-126 of the
    // smallest normal number, and 24 bits and some to spare.
    static constexpr float pole_floor = 0x1p-100f;
    static constexpr float root_of_pole_floor = 0x1p-50f;
    // So small that only the first term of a series in it counts, and so large that the next powers and their
    // products with the root of the floor are normal: subnormal numbers take many times as long.
    static constexpr float negligible = 0x1p-24f;
    static constexpr float infinity = __builtin_inff();
    static constexpr float largest_power_of_two = 0x1p127f;
    static constexpr float smallest_normal = 0x1p-126f;
    static constexpr float root_of_smallest_normal = 0x1p-63f;

    // atan z = z + z^3 (c0 + c1 z^2 + ...) for |z| <= 1, relative error 5.0e-9 (minimax).
    static constexpr float atan[] = {-0x1.55553ep-2f, 0x1.9991e4p-3f,  -0x1.2420bp-3f,
                                     0x1.c08ff2p-4f,  -0x1.58104ep-4f, 0x1.da138ap-5f,
                                     -0x1.fcb8e8p-6f, 0x1.627f9cp-7f,  -0x1.ceb9d4p-10f};
    // In two parts; the first has so few bits that its product with 0..2 is exact.
    static constexpr float half_pi = 0x1.921fcp0f;
    static constexpr float half_pi_rest = -0x1.5777a6p-21f;
    static constexpr float pi = 0x1.921fb6p1f;

    // sin r = r + r^3 (c0 + c1 r^2 + ...), cos r = 1 - r^2/2 + r^4 (c0 + c1 r^2 + ...) for |r| <= pi/4;
    // relative errors 4.0e-9 and 1.1e-10 (minimax).
    static constexpr float sin[] = {-0x1.555546p-3f, 0x1.110778p-7f, -0x1.9953f2p-13f};
    static constexpr float cos[] = {0x1.55554ap-5f, -0x1.6c0c1ap-10f, 0x1.99e0eep-16f};
    // The sum of the parts of pi/2, each but the last of 11 bits, so that products with whole numbers up to
    // 2^13 are exact: all that come with angles up to 2^13.
    static constexpr float half_pi_parts[] = {0x1.92p0f, 0x1.fb4p-12f, 0x1.444p-24f, 0x1.68c234p-39f};
    // The same where products are not rounded.
    static constexpr float half_pi_fused[] = {0x1.921fb6p0f, -0x1.777a5cp-25f, -0x1.ee59dap-50f};
    static constexpr float largest_angle = 0x1p13f;
    static constexpr float two_over_pi = 0x1.45f306p-1f;
    // Added to a number up to 2^22, it leaves no room for a fraction.
    static constexpr float round = 0x1.8p23f;

    // e^r - 1 = r + r^2 (c0 + c1 r + ...) for |r| <= ln 2 / 2, relative error 1.8e-9; log((1 + f) / (1 - f))
    // = 2 f + f^3 (c0 + c1 f^2 + ...) for |f| <= 0.172, relative error 3.0e-10.
    static constexpr float expm1[] = {0x1p-1f,       0x1.555556p-3f, 0x1.5554e8p-5f,
                                      0x1.1110ep-7f, 0x1.6d43bp-10f, 0x1.a1256cp-13f};
    static constexpr float log[] = {0x1.555556p-1f, 0x1.9999ecp-2f, 0x1.245c28p-2f, 0x1.ddd4dap-3f};
    // In two parts; the first has so few bits that its product with the exponent of a number is exact.
    static constexpr float ln_2 = 0x1.62e4p-1f;
    static constexpr float ln_2_rest = 0x1.7f7d1cp-20f;
    static constexpr float one_over_ln_2 = 0x1.715476p0f;
    static constexpr float sqrt_2 = 0x1.6a09e6p0f;

    // Of conformal rotors and their logarithms: components that are larger, and boosts, are out of the
    // domain, and of two terms whose difference is smaller than their sum times the noise nothing is left.
    static constexpr float largest_blade = 0x1p20f;
    static constexpr float largest_boost = 40;
    static constexpr float noise = 0x1p-16f;
    // So small that two terms of a series are enough.
    static constexpr float small_square = 0x1p-10f;
};

template <>
struct constants<double> {
    static constexpr double rounding = 0x1p-53;
    static constexpr double pole_threshold = 0x1p-106;
    static constexpr double pole_floor = 0x1p-960;
    static constexpr double root_of_pole_floor = 0x1p-480;
    static constexpr double negligible = 0x1p-60;
    static constexpr double infinity = __builtin_inf();
    static constexpr double largest_power_of_two = 0x1p1023;
    static constexpr double smallest_normal = 0x1p-1022;
    static constexpr double root_of_smallest_normal = 0x1p-511;

    // Relative error 8.8e-18.
    static constexpr double atan[] = {
        -0x1.5555555555526p-2, 0x1.99999999955adp-3,  -0x1.249249237f384p-3,  0x1.c71c717fc8048p-4,
        -0x1.745d11adf4e31p-4, 0x1.3b1366949b3d3p-4,  -0x1.110e50fbee03bp-4,  0x1.e1bba485d8677p-5,
        -0x1.ae5e6ab2bcf95p-5, 0x1.82dabd6f8e309p-5,  -0x1.59a3bd2407352p-5,  0x1.2c2ddaae85aeep-5,
        -0x1.e9f87c4d60209p-6, 0x1.683ae75742be8p-6,  -0x1.c78c5099d969ap-7,  0x1.d7b4474c488d7p-8,
        -0x1.7a349fd4d3b3fp-9, 0x1.b3f3c9a24962ap-11, -0x1.3f303a8519752p-13, 0x1.bbe3d9b7b963ep-17};
    static constexpr double half_pi = 0x1.921fb54442d20p0;
    static constexpr double half_pi_rest = -0x1.ee59d9cceba40p-50;
    static constexpr double pi = 0x1.921fb54442d18p1;

    // Relative errors 3.7e-18 and 4.8e-20.
    static constexpr double sin[] = {-0x1.5555555555548p-3, 0x1.111111110f730p-7,   -0x1.a01a019be9213p-13,
                                     0x1.71de35552aeb6p-19, -0x1.ae5e4b8373053p-26, 0x1.5d8b556a87505p-33};
    static constexpr double cos[] = {0x1.555555555554cp-5,   -0x1.6c16c16c1521bp-10, 0x1.a01a019cbeb6ep-16,
                                     -0x1.27e4f812123d5p-22, 0x1.1ee9f0ccabf6dp-29,  -0x1.8fb0e1de41db5p-37};
    // For whole numbers up to 2^20: 33 bits, so many that the second difference is exact, 33 bits, and the
    // rest.
    static constexpr double half_pi_parts[] = {0x1.921fb544p0, 0x1.0b46p-34, 0x1.1a626331p-54,
                                               0x1.1701b839a252p-88};
    static constexpr double half_pi_fused[] = {0x1.921fb54442d18p0, 0x1.1a62633145c07p-54,
                                               -0x1.f1976b7ed8fbcp-110};
    static constexpr double largest_angle = 0x1p20;
    static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    static constexpr double round = 0x1.8p52;

    // Relative errors 8.1e-19 and 5.3e-19.
    static constexpr double expm1[] = {0x1p-1,
                                       0x1.5555555555557p-3,
                                       0x1.5555555555556p-5,
                                       0x1.11111111100bep-7,
                                       0x1.6c16c16c162c3p-10,
                                       0x1.a01a01abf85abp-13,
                                       0x1.a01a01a6e1e2ap-16,
                                       0x1.71de01fdbf9cap-19,
                                       0x1.27e4db46cddd1p-22,
                                       0x1.af4e554377204p-26,
                                       0x1.1f7340dbc337ep-29};
    static constexpr double log[] = {0x1.5555555555555p-1, 0x1.9999999999a39p-2, 0x1.2492492476a1ap-2,
                                     0x1.c71c7201a55d7p-3, 0x1.745cf8e4bba1bp-3, 0x1.3b1c3c1c81c90p-3,
                                     0x1.0fbde0f4ad179p-3, 0x1.0c0aff044a981p-3};
    static constexpr double ln_2 = 0x1.62e42fefa3p-1;
    static constexpr double ln_2_rest = 0x1.3de6af278ece6p-42;
    static constexpr double one_over_ln_2 = 0x1.71547652b82fep0;
    static constexpr double sqrt_2 = 0x1.6a09e667f3bcdp0;

    static constexpr double largest_blade = 0x1p200;
    static constexpr double largest_boost = 300;
    static constexpr double noise = 0x1p-40;
    static constexpr double small_square = 0x1p-20;
};

}  // namespace
}  // namespace swivel

#endif
