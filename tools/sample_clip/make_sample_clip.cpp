// Writes the sample clip as a BVH file to a path, or to standard output for "-".

#include <cstdio>
#include <string>

#include "sample_clip.hpp"
#include "swivel/clip/write.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_sample_clip FILE.bvh|-\n", stderr);
        return 2;
    }
    const std::string path = argv[1];
    const std::string text = swivel::clip::write_bvh(swivel::clip::make_sample_clip());
    std::FILE* const file = path == "-" ? stdout : std::fopen(path.c_str(), "wb");
    const bool written = file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if (!file || std::fclose(file) != 0 || !written) {
        std::fprintf(stderr, "%s: cannot be written\n", path.c_str());
        return 1;
    }
    return 0;
}
