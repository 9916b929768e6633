in vec3 place;
in float skirt;
uniform vec4 wire_colour;
out vec4 result;
void main() { result = wire_colour; }
