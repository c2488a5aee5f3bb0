// What pixels look up textures by: the places, in the eye's coordinates and the shape's own, and
// the mesh's texture coordinates, of which what is not given is 0, 0, 0, 1.
out vec3 seenAt;
out vec3 seenNormal;
out vec3 localAt;
out vec3 localNormal;
out vec4 set0;
MORE_INPUTS
#ifdef TANGENTS
// Where the first and the second axis of a normal texture lie, given by the author.
layout(location = TANGENTS) in vec4 tangent;
out vec3 firstAxis;
out vec3 secondAxis;
#endif

void passCoordinates() {
  vec4 local = vec4(position, 1.0);
  seenAt = vec3(dot(object[4], local), dot(object[5], local), dot(object[6], local));
  seenNormal =
      vec3(dot(object[7].xyz, normal), dot(object[8].xyz, normal), dot(object[9].xyz, normal));
  localAt = position;
  localNormal = normal;
  set0 = vec4(texCoord, 0.0, 1.0);
#ifdef TANGENTS
  vec3 second = cross(normal, tangent.xyz) * tangent.w;
  firstAxis = vec3(
      dot(object[4].xyz, tangent.xyz),
      dot(object[5].xyz, tangent.xyz),
      dot(object[6].xyz, tangent.xyz));
  secondAxis =
      vec3(dot(object[4].xyz, second), dot(object[5].xyz, second), dot(object[6].xyz, second));
#endif
  MORE_PASSED
}
