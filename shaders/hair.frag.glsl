in vec4 hair;

layout(location = 0) out vec4 layer;

void main() { layer = hair; }
