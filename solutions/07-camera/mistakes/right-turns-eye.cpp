    eye = rotation(degrees, up) * eye;
