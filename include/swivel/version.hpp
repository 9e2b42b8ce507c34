#ifndef SWIVEL_VERSION_HPP
#define SWIVEL_VERSION_HPP

namespace swivel {

// "major.minor.patch", the same as the CMake package version.
const char* version() noexcept;

}  // namespace swivel

#endif
