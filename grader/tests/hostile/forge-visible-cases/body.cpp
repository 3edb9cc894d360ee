(void)axis;
return table(degrees);
