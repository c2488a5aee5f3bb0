// Flat marks in pixels from the upper left corner of a page.
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 color;
uniform vec2 page;  // its width and height
out vec4 shade;

void main() {
  shade = color;
  gl_Position = vec4(2.0 * position.x / page.x - 1.0, 1.0 - 2.0 * position.y / page.y, 0.0, 1.0);
}
