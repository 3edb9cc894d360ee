// Part of our programs that run in a sandbox. LeakSanitizer traces its own process, which the
// sandbox refuses; without a sanitizer nobody asks.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0";
}
