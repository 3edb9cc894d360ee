    (void)degrees;
    eye = eye_default;
    up = up_default;
