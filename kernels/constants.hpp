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

    // atan z = z + z^3 (c0 + c1 z^2 + ...) for |z| <= tan(pi/8), relative error 6.8e-10 (minimax).
    static constexpr float atan[] = {-0x1.55554ap-2f, 0x1.999196p-3f, -0x1.23b52p-3f, 0x1.b1ec1p-4f,
                                     -0x1.f1ed06p-5f};
    static constexpr float tan_eighth_pi = 0x1.a8279ap-2f;
    // pi/4 in two parts; the first has so few bits that its product with 0..4 is exact.
    static constexpr float quarter_pi = 0x1.921fcp-1f;
    static constexpr float quarter_pi_rest = -0x1.5777a6p-22f;
};

template <>
struct constants<double> {
    static constexpr double pole_threshold = 0x1p-106;
    static constexpr double pole_floor = 0x1p-960;
    static constexpr double infinity = __builtin_inf();
    static constexpr double largest_power_of_two = 0x1p1023;

    // Relative error 1.3e-18.
    static constexpr double atan[] = {-0x1.555555555553dp-2, 0x1.99999999957ccp-3,  -0x1.24924922aa487p-3,
                                      0x1.c71c70e50c70dp-4,  -0x1.745cf8c3451b8p-4, 0x1.3b1117922063bp-4,
                                      -0x1.10eba8a86ce02p-4, 0x1.df0e7e79bebf7p-5,  -0x1.9ccf77df88909p-5,
                                      0x1.37ce0f68b319fp-5,  -0x1.255b1da2e278dp-6};
    static constexpr double tan_eighth_pi = 0x1.a827999fcef32p-2;
    static constexpr double quarter_pi = 0x1.921fb54442d20p-1;
    static constexpr double quarter_pi_rest = -0x1.ee59d9cceba40p-51;
};

}  // namespace
}  // namespace swivel

#endif
