head -c 5000 /dev/urandom > 04-mandelbrot/shaders/mandelbrot.frag
