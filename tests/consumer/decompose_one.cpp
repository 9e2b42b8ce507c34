// What a user of the library compiles: one quaternion in, its swing and twist out.

#include <cmath>
#include <cstdio>
#include <swivel/swivel.hpp>

#ifdef XSIMD_HPP
#error "a public header includes xsimd"
#endif

namespace {

bool near(float a, double b) { return std::fabs(static_cast<double>(a) - b) < 1e-6; }

}  // namespace

int main() {
    // 90 degrees about z, then 90 degrees about x.
    float q[4] = {0.5F, -0.5F, 0.5F, 0.5F};
    float swing[4] = {}, twist[4] = {};
    const swivel::status s = swivel::decompose(swivel::aos_xyzw<const float>(q, 1), swivel::axis::z,
                                               swivel::aos_xyzw(swing, 1), swivel::aos_xyzw(twist, 1));
    const double h = std::sqrt(0.5);
    const bool right = s == swivel::status::ok &&  //
                       near(swing[0], h) && near(swing[1], 0) && near(swing[2], 0) && near(swing[3], h) &&
                       near(twist[0], 0) && near(twist[1], 0) && near(twist[2], h) && near(twist[3], h);
    std::printf("swivel %s, %s: swing %g %g %g %g, twist %g %g %g %g: %s\n", swivel::version(),
                swivel::name(swivel::active_isa()), swing[0], swing[1], swing[2], swing[3], twist[0],
                twist[1], twist[2], twist[3], right ? "right" : "wrong");
    return right ? 0 : 1;
}
