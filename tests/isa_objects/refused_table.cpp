// Nothing wrong but that it comes twice, or with AVX instructions where they do not belong.
static float product(const float* a) { return a[0] * a[1]; }

extern float (*const table)(const float*);
float (*const table)(const float*) = product;
