// Put in front of every file of a submission, precompiled: what nearly all of them include anyway.
// A file that relies on it alone does not compile in its window, which has no prelude.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>
