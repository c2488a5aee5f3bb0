// Marks over a scene: a mesh in one colour.
layout(location = 0) in vec3 position;
uniform mat4 place;  // to clip coordinates

void main() {
  gl_Position = place * vec4(position, 1.0);
}
