#ifdef SHADOWS
float a = 1.0;
