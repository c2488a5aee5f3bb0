// A side of the cube of a background's pictures, at the far end of the depth range.
uniform mat4 toClip;
// Its middle, and from there to its right and upper edge.
uniform vec3 side[3];
out vec2 coordinate;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  coordinate = corner * 0.5 + 0.5;
  vec3 at = side[0] + side[1] * corner.x + side[2] * corner.y;
  gl_Position = (toClip * vec4(at, 1.0)).xyww;
}
