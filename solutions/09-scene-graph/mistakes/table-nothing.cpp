    (void)table, (void)top, (void)leg, (void)piece, (void)size, (void)thickness;
