#line 1 "/etc/passwd"
int x = no_such_name;
