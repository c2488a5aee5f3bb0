// Flat marks on a page, from its upper left corner: in pixels of the picture, or somewhere in the world.
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 color;
#ifdef IN_WORLD
uniform mat4 place;  // from the page's plane to clip space
#else
uniform vec2 page;  // its width and height
#endif
out vec4 shade;

void main() {
  shade = color;
#ifdef IN_WORLD
  gl_Position = place * vec4(position, 0.0, 1.0);
#else
  gl_Position = vec4(2.0 * position.x / page.x - 1.0, 1.0 - 2.0 * position.y / page.y, 0.0, 1.0);
#endif
}
