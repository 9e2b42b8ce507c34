#ifndef SWIVEL_BENCH_PEERS_PLAIN_LOOPS_HPP
#define SWIVEL_BENCH_PEERS_PLAIN_LOOPS_HPP

#include <cmath>

#include "peers.hpp"

namespace swivel_bench {

template <class T, class Width>
void plain<T, Width>::decompose(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                const T* __restrict w, T ax, T ay, T az, T* __restrict sx, T* __restrict sy,
                                T* __restrict sz, T* __restrict sw, T* __restrict tx, T* __restrict ty,
                                T* __restrict tz, T* __restrict tw, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T u = x[i] * ax + y[i] * ay + z[i] * az;
        const T scale = 1 / std::sqrt(w[i] * w[i] + u * u);
        const T c = w[i] * scale, d = u * scale;
        const T px = x[i] - u * ax, py = y[i] - u * ay, pz = z[i] - u * az;
        sx[i] = c * px + d * (ay * pz - az * py);
        sy[i] = c * py + d * (az * px - ax * pz);
        sz[i] = c * pz + d * (ax * py - ay * px);
        sw[i] = c * w[i] + d * u;
        tx[i] = d * ax;
        ty[i] = d * ay;
        tz[i] = d * az;
        tw[i] = c;
    }
}

template <class T, class Width>
void plain<T, Width>::decompose_z(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                  const T* __restrict w, T* __restrict sx, T* __restrict sy, T* __restrict sz,
                                  T* __restrict sw, T* __restrict tx, T* __restrict ty, T* __restrict tz,
                                  T* __restrict tw, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T t = w[i] * w[i] + z[i] * z[i], scale = 1 / std::sqrt(t);
        const T c = w[i] * scale, d = z[i] * scale;
        sx[i] = c * x[i] - d * y[i];
        sy[i] = c * y[i] + d * x[i];
        sz[i] = 0;
        sw[i] = t * scale;
        tx[i] = 0;
        ty[i] = 0;
        tz[i] = d;
        tw[i] = c;
    }
}

template <class T, class Width>
void plain<T, Width>::decompose_compact(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                        const T* __restrict w, T* __restrict s1, T* __restrict s2,
                                        T* __restrict sc, T* __restrict ts, T* __restrict tc,
                                        std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T t = w[i] * w[i] + z[i] * z[i], scale = 1 / std::sqrt(t);
        const T c = w[i] * scale, d = z[i] * scale;
        s1[i] = c * x[i] - d * y[i];
        s2[i] = c * y[i] + d * x[i];
        sc[i] = t * scale;
        ts[i] = d;
        tc[i] = c;
    }
}

template <class T, class Width>
void plain<T, Width>::twist(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                            const T* __restrict w, T ax, T ay, T az, T* __restrict tx, T* __restrict ty,
                            T* __restrict tz, T* __restrict tw, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T u = x[i] * ax + y[i] * ay + z[i] * az;
        const T scale = 1 / std::sqrt(w[i] * w[i] + u * u), d = u * scale;
        tx[i] = d * ax;
        ty[i] = d * ay;
        tz[i] = d * az;
        tw[i] = w[i] * scale;
    }
}

template <class T, class Width>
void plain<T, Width>::swing(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                            const T* __restrict w, T ax, T ay, T az, T* __restrict sx, T* __restrict sy,
                            T* __restrict sz, T* __restrict sw, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T u = x[i] * ax + y[i] * ay + z[i] * az;
        const T t = w[i] * w[i] + u * u, scale = 1 / std::sqrt(t);
        const T c = w[i] * scale, d = u * scale;
        const T px = x[i] - u * ax, py = y[i] - u * ay, pz = z[i] - u * az;
        sx[i] = c * px + d * (ay * pz - az * py);
        sy[i] = c * py + d * (az * px - ax * pz);
        sz[i] = c * pz + d * (ax * py - ay * px);
        sw[i] = t * scale;
    }
}

template <class T, class Width>
void plain<T, Width>::twist_angle(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                  const T* __restrict w, T ax, T ay, T az, T* __restrict radians,
                                  std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T u = x[i] * ax + y[i] * ay + z[i] * az;
        radians[i] = 2 * std::atan2(u, w[i]);
    }
}

template <class T, class Width>
void plain<T, Width>::compose(const T* __restrict sx, const T* __restrict sy, const T* __restrict sz,
                              const T* __restrict sw, const T* __restrict tx, const T* __restrict ty,
                              const T* __restrict tz, const T* __restrict tw, T* __restrict x,
                              T* __restrict y, T* __restrict z, T* __restrict w, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = sw[i] * tx[i] + sx[i] * tw[i] + sy[i] * tz[i] - sz[i] * ty[i];
        y[i] = sw[i] * ty[i] + sy[i] * tw[i] + sz[i] * tx[i] - sx[i] * tz[i];
        z[i] = sw[i] * tz[i] + sz[i] * tw[i] + sx[i] * ty[i] - sy[i] * tx[i];
        w[i] = sw[i] * tw[i] - sx[i] * tx[i] - sy[i] * ty[i] - sz[i] * tz[i];
    }
}

template <class T, class Width>
void plain<T, Width>::compose_compact(const T* __restrict s1, const T* __restrict s2, const T* __restrict sc,
                                      const T* __restrict ts, const T* __restrict tc, T* __restrict x,
                                      T* __restrict y, T* __restrict z, T* __restrict w,
                                      std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = s1[i] * tc[i] + s2[i] * ts[i];
        y[i] = s2[i] * tc[i] - s1[i] * ts[i];
        z[i] = sc[i] * ts[i];
        w[i] = sc[i] * tc[i];
    }
}

template <class T, class Width>
void plain<T, Width>::normalize(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                const T* __restrict w, T* __restrict ox, T* __restrict oy, T* __restrict oz,
                                T* __restrict ow, std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T scale = 1 / std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i] + w[i] * w[i]);
        ox[i] = x[i] * scale;
        oy[i] = y[i] * scale;
        oz[i] = z[i] * scale;
        ow[i] = w[i] * scale;
    }
}

template <class T, class Width>
void plain<T, Width>::rotate(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                             const T* __restrict w, const T* __restrict vx, const T* __restrict vy,
                             const T* __restrict vz, T* __restrict ox, T* __restrict oy, T* __restrict oz,
                             std::size_t n) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        const T tx = 2 * (y[i] * vz[i] - z[i] * vy[i]);
        const T ty = 2 * (z[i] * vx[i] - x[i] * vz[i]);
        const T tz = 2 * (x[i] * vy[i] - y[i] * vx[i]);
        ox[i] = vx[i] + w[i] * tx + (y[i] * tz - z[i] * ty);
        oy[i] = vy[i] + w[i] * ty + (z[i] * tx - x[i] * tz);
        oz[i] = vz[i] + w[i] * tz + (x[i] * ty - y[i] * tx);
    }
}

template <class T, class Width>
void plain<T, Width>::align_signs(const T* __restrict x, const T* __restrict y, const T* __restrict z,
                                  const T* __restrict w, T* __restrict ox, T* __restrict oy, T* __restrict oz,
                                  T* __restrict ow, std::size_t n) noexcept {
    T px = 0, py = 0, pz = 0, pw = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const T sign = x[i] * px + y[i] * py + z[i] * pz + w[i] * pw < 0 ? T(-1) : T(1);
        ox[i] = px = sign * x[i];
        oy[i] = py = sign * y[i];
        oz[i] = pz = sign * z[i];
        ow[i] = pw = sign * w[i];
    }
}

}  // namespace swivel_bench

#endif
