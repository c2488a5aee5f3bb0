// What pixels look up textures by: the places, in the eye's coordinates and the shape's own, and
// the mesh's texture coordinates, of which what is not given is 0, 0, 0, 1.
out vec3 seenAt;
out vec3 seenNormal;
out vec3 localAt;
out vec3 localNormal;
out vec4 set0;
MORE_INPUTS

void passCoordinates() {
  vec4 local = vec4(position, 1.0);
  seenAt = vec3(dot(object[4], local), dot(object[5], local), dot(object[6], local));
  seenNormal =
      vec3(dot(object[7].xyz, normal), dot(object[8].xyz, normal), dot(object[9].xyz, normal));
  localAt = position;
  localNormal = normal;
  set0 = vec4(texCoord, 0.0, 1.0);
  MORE_PASSED
}
