#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
