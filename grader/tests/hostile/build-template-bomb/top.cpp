template <int D, class... T> struct Bomb : Bomb<D - 1, T..., int>, Bomb<D - 1, T..., char> {};
template <class... T> struct Bomb<0, T...> {};
Bomb<30> bomb;
