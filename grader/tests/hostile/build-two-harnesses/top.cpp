extern "C" void cg_register_harness(void*) {}
