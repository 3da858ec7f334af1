"""Programs that kill or stall the driver."""
VERSION = "#version 330 compatibility\n"

# One dispatch that no machine finishes.
ENDLESS = ("#version 430 compatibility\nlayout(local_size_x = 64) in;\n"
           "const ivec3 workGroups = ivec3(65535, 65535, 1);\n"
           "layout(rgba8) uniform image2D colorimg0;\n"
           "void main() { imageStore(colorimg0, ivec2(gl_GlobalInvocationID.xy & 7u), vec4(1)); }\n")
# Far larger than what the compiler of llvmpipe can count; glslang takes it. In a struct: arrays of this length are refused.
DEADLY = (VERSION + "uniform int frameCounter;\nstruct Row { float x[2147483647]; };\nvoid main() {\nRow a;\n"
          "a.x[frameCounter] = 1.0;\ngl_FragColor = vec4(a.x[frameCounter + 1]);\n}\n")
