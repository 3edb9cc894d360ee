    eye = target + rotation(degrees, up) * (eye - target);
