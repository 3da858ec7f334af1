/*
const int colortex3Format = RGBA16;
const int colortex4Format = RGBA16G;
const int colortex38Format = RGBA99;
const vec4 colortex5ClearColor = vec4(1.0);
*/
const int shadowMapResolution = 0;
const float sunPathRotation = 20.0 * 2.0;
