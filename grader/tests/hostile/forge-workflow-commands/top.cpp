#include <iostream>
#include <stdexcept>
