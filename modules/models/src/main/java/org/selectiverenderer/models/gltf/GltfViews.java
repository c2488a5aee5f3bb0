package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the cameras and lights of nodes, which both look along -z of their node in glTF. */
final class GltfViews {
  /** The radius of a light without a range, in metres: beyond it the light is not seen. */
  private static final double UNLIMITED = 1e6;

  /**
   * Candela of a lamp that makes all white within many metres, where no camera is exposed to it.
   */
  private static final double BRIGHT = 1000;

  /** The luminous efficacy by which candela are defined, and by which Blender multiplies watts. */
  private static final double LUMENS_PER_WATT = 683;

  private final GltfFile file;
  private final X3dWriter out;
  private final DefNames names;
  private final GltfProblems problems;
  private final boolean dimmed;

  GltfViews(GltfFile file, X3dWriter out, DefNames names, GltfProblems problems) {
    this.file = file;
    this.out = out;
    this.names = names;
    this.problems = problems;
    dimmed =
        StreamSupport.stream(lights().spliterator(), false)
            .anyMatch(light -> !isDirectional(light) && intensity(light) > BRIGHT);
  }

  /**
   * Writes what a node has.
   *
   * @param name the node's name, for those that have none themselves
   * @param scale by what the node and those around it multiply lengths
   */
  void write(JsonNode node, String path, String name, double scale) {
    JsonNode camera = file.referred(node, "camera", "cameras");
    if (camera.isObject()) {
      camera(camera, camera.has("name") ? GltfFile.text(camera, "name") : name);
    }
    int light = GltfFile.index(node.path("extensions").path("KHR_lights_punctual"), "light");
    JsonNode lights = lights();
    if (light >= 0 && lights.path(light).isObject()) {
      light(lights.path(light), path, lights.path(light).path("name").asText(name), scale);
    }
  }

  private JsonNode lights() {
    return file.root().path("extensions").path("KHR_lights_punctual").path("lights");
  }

  private void camera(JsonNode camera, String name) {
    boolean ortho = camera.path("type").asText("").equals("orthographic");
    JsonNode lens = camera.path(ortho ? "orthographic" : "perspective");
    String def = names.unique(name, "camera");
    out.open(ortho ? "OrthoViewpoint" : "Viewpoint", "DEF", def);
    out.attribute("description", name.isBlank() ? def : name);
    out.attribute("position", "0 0 0");
    if (ortho) {
      double x = positive(lens, "xmag", 1);
      double y = positive(lens, "ymag", 1);
      out.attribute("fieldOfView", Numbers.of(-x, -y, x, y));
    } else {
      out.attribute("fieldOfView", Numbers.of(fieldOfView(lens)));
    }
    double near = GltfFile.number(lens, "znear", -1);
    double far = GltfFile.number(lens, "zfar", -1);
    if (near > 0) {
      out.attribute("nearDistance", Numbers.of(near));
    }
    if (far > near && near > 0) {
      out.attribute("farDistance", Numbers.of(far));
    }
    out.close();
  }

  /** Returns the smaller angle of view, which is X3D's; glTF's is the vertical one. */
  private static double fieldOfView(JsonNode lens) {
    double vertical = positive(lens, "yfov", Math.PI / 4);
    double aspect = positive(lens, "aspectRatio", 1);
    double half = Math.min(vertical, 3) / 2;
    return aspect < 1 ? 2 * Math.atan(Math.tan(half) * aspect) : 2 * half;
  }

  private static double positive(JsonNode from, String member, double otherwise) {
    double value = GltfFile.number(from, member, otherwise);
    return value > 0 ? value : otherwise;
  }

  private static double intensity(JsonNode light) {
    return Math.max(0, GltfFile.number(light, "intensity", 1));
  }

  private static boolean isDirectional(JsonNode light) {
    return light.path("type").asText("").equals("directional");
  }

  private void light(JsonNode light, String path, String name, double scale) {
    double[] color = GltfFile.numbers(light, "color", 1, 1, 1);
    double intensity = intensity(light);
    String kind = light.path("type").asText("");
    if (dimmed && !isDirectional(light)) {
      intensity /= LUMENS_PER_WATT;
      problems.tell(
          path,
          "it is a light as physics measures it, in candela, and X3D has no exposure; all such "
              + "lights are divided by 683 (lumens per watt)");
    }
    List<String> fields = new ArrayList<>(List.of("DEF", names.unique(name, "light")));
    fields.addAll(List.of("global", "true", "intensity", Numbers.of(intensity)));
    double[] shown = {Numbers.unit(color[0]), Numbers.unit(color[1]), Numbers.unit(color[2])};
    fields.addAll(List.of("color", Numbers.of(shown)));
    if (!isDirectional(light)) {
      // Light falls off by the square of the distance in the scene; X3D measures in the light's own
      // coordinates (X3D 4.0, 17.2.1.4).
      String radius = Numbers.of(positive(light, "range", UNLIMITED) / scale);
      fields.addAll(List.of("attenuation", Numbers.of(0, 0, scale * scale), "radius", radius));
    }
    switch (kind) {
      case "directional" -> out.empty("DirectionalLight", fields.toArray(String[]::new));
      case "spot" -> {
        JsonNode spot = light.path("spot");
        double outer = Math.min(positive(spot, "outerConeAngle", Math.PI / 4), Math.PI / 2);
        double inner = Math.max(0, GltfFile.number(spot, "innerConeAngle", 0));
        fields.addAll(List.of("direction", "0 0 -1", "cutOffAngle", Numbers.of(outer)));
        fields.addAll(List.of("beamWidth", Numbers.of(Math.min(inner, outer))));
        out.empty("SpotLight", fields.toArray(String[]::new));
      }
      default -> out.empty("PointLight", fields.toArray(String[]::new));
    }
  }
}
