#include <sched.h>
#include <sys/resource.h>
