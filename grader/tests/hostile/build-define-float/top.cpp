#define float double
