#include <no_such_header_at_all.h>
