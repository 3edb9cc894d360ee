throw std::runtime_error("<script>alert(1)</script><img src=x onerror=alert(2)> =1+cmd|' /C calc'!A0");
