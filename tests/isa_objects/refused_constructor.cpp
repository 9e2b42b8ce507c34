// Runs before main, on any processor.
static float initial() {
    volatile float a = 1;
    return a;
}
static const float first = initial();

extern const float* const table;
const float* const table = &first;
