#define main forged_main
