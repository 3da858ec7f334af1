vec3 red() { return vec3(1, 0, 0); }
