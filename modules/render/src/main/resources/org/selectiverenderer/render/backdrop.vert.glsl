// One triangle over the whole viewport, at the far end of the depth range.
// Columns that take clip coordinates at the far plane to directions in the world.
uniform vec3 unproject[3];
out vec3 direction;

void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  direction = unproject[0] * corner.x + unproject[1] * corner.y + unproject[2];
  gl_Position = vec4(corner, 1.0, 1.0);
}
