    (void)degrees;
    eye = eye_default;
