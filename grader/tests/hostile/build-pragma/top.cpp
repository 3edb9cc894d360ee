#pragma GCC dependency "/etc/passwd"
#pragma GCC system_header
#pragma comment(lib, "forged")
#pragma GCC push_options
