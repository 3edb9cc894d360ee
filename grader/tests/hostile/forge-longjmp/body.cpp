mark();
std::longjmp(place, 1);
