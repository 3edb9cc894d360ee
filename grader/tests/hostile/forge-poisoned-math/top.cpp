extern "C" float sinf(float) { return 0.0f; }
extern "C" float cosf(float) { return 1.0f; }
