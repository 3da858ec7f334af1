#version 330 compatibility
#error never seen: this program is switched off
#endif
void main() {}
