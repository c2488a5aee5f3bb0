package org.selectiverenderer.browser.instance;

import org.selectiverenderer.browser.scene.Node;

/** Reads the field values of a light node. */
final class LightReader {
  private static final float[] NONE = {0, 0, 0};
  private static final float[] CONSTANT = {1, 0, 0};
  private static final float[] DOWN = {0, 0, -1};

  private LightReader() {}

  static boolean isLight(Node node) {
    return kind(node) != null;
  }

  private static Light.@org.jspecify.annotations.Nullable Kind kind(Node node) {
    return switch (node.type().name()) {
      case "DirectionalLight" -> Light.Kind.DIRECTIONAL;
      case "PointLight" -> Light.Kind.POINT;
      case "SpotLight" -> Light.Kind.SPOT;
      default -> null;
    };
  }

  static Light read(Node node) {
    Light.Kind kind = kind(node);
    boolean placed = kind != Light.Kind.DIRECTIONAL;
    boolean spot = kind == Light.Kind.SPOT;
    return new Light(
        kind,
        node.bool("on"),
        node.floats("color"),
        node.number("intensity"),
        node.number("ambientIntensity"),
        placed ? node.floats("location") : NONE,
        kind == Light.Kind.POINT ? DOWN : node.floats("direction"),
        placed ? node.floats("attenuation") : CONSTANT,
        placed ? reach(node.number("radius")) : Float.POSITIVE_INFINITY,
        spot ? node.number("beamWidth") : 0,
        spot ? node.number("cutOffAngle") : 0,
        node.bool("global"));
  }

  /** Returns a radius; a negative one, which X3D forbids, means no limit as in other browsers. */
  private static float reach(float radius) {
    return radius < 0 ? Float.POSITIVE_INFINITY : radius;
  }
}
