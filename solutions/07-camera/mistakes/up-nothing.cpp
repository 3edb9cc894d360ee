    (void)degrees;
