// The yardstick of the benchmark: the least that a lit surface needs.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 place;  // to clip coordinates
out vec3 facing;

void main() {
  gl_Position = place * vec4(position, 1.0);
  facing = normal;
}
