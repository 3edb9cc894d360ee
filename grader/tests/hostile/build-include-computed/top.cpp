#define NAME "@SECRET@"
#define OTHER NAME
#include OTHER
