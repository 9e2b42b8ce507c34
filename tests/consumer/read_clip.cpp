// What a user of the library of clips compiles: a text in, the rotation of a joint out.

#include <cstdio>
#include <swivel/clip/read.hpp>
#include <swivel/clip/write.hpp>

#ifdef XSIMD_HPP
#error "a public header includes xsimd"
#endif

int main() {
    const swivel::clip::read_result r = swivel::clip::read_bvh(
        "HIERARCHY ROOT Door { OFFSET 0 0 0 CHANNELS 1 Yrotation }\n"
        "MOTION Frames: 2 Frame Time: 0.5\n0\n180\n");
    if (!r) {
        std::printf("%zu:%zu: %s\n", r.error.line, r.error.column, r.error.what.c_str());
        return 1;
    }
    double q[8] = {};
    const swivel::status s = swivel::clip::joint_rotations(*r.value, 0, swivel::aos_xyzw(q, 2));
    const bool right = s == swivel::status::ok && q[1] == 0 && q[3] == 1 && q[5] == 1 && q[7] == 0 &&
                       swivel::clip::read_bvh(swivel::clip::write_bvh(*r.value)).value == r.value;
    std::printf("rotations %g %g %g %g, %g %g %g %g: %s\n", q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7],
                right ? "right" : "wrong");
    return right ? 0 : 1;
}
