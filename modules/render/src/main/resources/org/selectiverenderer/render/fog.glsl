// How much of a colour is left behind fog (X3D 4.0, 24.2.2.4). Fog: its colour, and how far one
// sees in it.
in vec3 fogPlace;
uniform vec4 fog;

float leftInFog() {
  float distance = length(fogPlace);
#ifdef EXPONENTIAL
  return distance >= fog.w ? 0.0 : exp(-distance / (fog.w - distance));
#else
  return max(0.0, 1.0 - distance / fog.w);
#endif
}
