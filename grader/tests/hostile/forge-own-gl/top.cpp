extern "C" void glReadPixels(...) {}
extern "C" void glDrawElements(...) {}
