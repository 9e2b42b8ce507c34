// An inline function that is called out of line: every object that has it offers its copy to all.
inline __attribute__((noinline)) float twice(float a) { return a + a; }

extern float (*const table)(float);
float (*const table)(float) = twice;
