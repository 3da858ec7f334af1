#version 330 compatibility
#error the nether has no deferred pass
void main() {}
