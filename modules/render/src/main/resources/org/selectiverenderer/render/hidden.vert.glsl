// Nearer than everything that is drawn after it.
layout(location = 0) in vec2 position;

void main() {
  gl_Position = vec4(position, -1.0, 1.0);
}
