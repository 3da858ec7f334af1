// The outline of the block that the player looks at, which darkens what lies behind it.
#if defined VERTEX_STAGE

out vec4 tint;

void main() {
    gl_Position = ftransform();
    tint = gl_Color;
}

#else

in vec4 tint;

/* RENDERTARGETS: 1 */
layout(location = 0) out vec4 out_albedo;

void main() {
    out_albedo = tint;  // alpha blends; the material byte stays as it is
}

#endif
