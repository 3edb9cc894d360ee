#if __has_include("@SECRET@")
#error it is there
#endif
