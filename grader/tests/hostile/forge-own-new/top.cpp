#include <cstdlib>
#include <new>
void* operator new(std::size_t) { return nullptr; }
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}
