// Cuts off what lies behind planes (X3D 4.0, 11.4.1): in the eye's coordinates, front positive.
uniform vec4 planes[PLANES];
out float gl_ClipDistance[PLANES];

void cutOff(vec3 place) {
  for (int i = 0; i < PLANES; i++) {
    gl_ClipDistance[i] = dot(planes[i], vec4(place, 1.0));
  }
}
