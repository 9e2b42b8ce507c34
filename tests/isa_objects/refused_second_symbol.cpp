extern float (*const table)(float);
float helper(float a) { return a + a; }
float (*const table)(float) = helper;
