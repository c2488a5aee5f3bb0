package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.formats.image.Srgb;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Writes viewpoints as cameras, and lights by KHR_lights_punctual, with their intensities. */
final class GltfViewWriter {
  /** The near plane where a scene leaves it to the browser, in units of the scene. */
  private static final double NEAR = 0.05;

  /** The far plane of parallel views, which need one, where a scene leaves it to the browser. */
  private static final double FAR = 10_000;

  private static final double WIDEST = 3.1415;

  private final GltfDocument out;

  GltfViewWriter(GltfDocument out) {
    this.out = out;
  }

  static boolean isView(NodeView node) {
    return node.type().name().equals("Viewpoint") || node.type().name().equals("OrthoViewpoint");
  }

  static boolean isLight(NodeView node) {
    return switch (node.type().name()) {
      case "DirectionalLight", "PointLight", "SpotLight" -> true;
      default -> false;
    };
  }

  /** Returns the node of a viewpoint. */
  ObjectNode view(NodeView view) {
    ObjectNode camera = out.object();
    double near = positive(view.number("nearDistance"), NEAR);
    double far = positive(view.number("farDistance"), 0);
    ObjectNode lens;
    if (view.type().name().equals("Viewpoint")) {
      lens = camera.put("type", "perspective").putObject("perspective");
      lens.put("yfov", Math.min(positive(view.number("fieldOfView"), Math.PI / 4), WIDEST));
    } else {
      float[] box = view.floats("fieldOfView");
      lens = camera.put("type", "orthographic").putObject("orthographic");
      boolean whole = box.length >= 4;
      lens.put("xmag", positive(whole ? (box[2] - (double) box[0]) / 2 : 1, 1));
      lens.put("ymag", positive(whole ? (box[3] - (double) box[1]) / 2 : 1, 1));
      far = far > near ? far : Math.max(FAR, 2 * near);
    }
    lens.put("znear", near);
    if (far > near) {
      lens.put("zfar", far);
    }
    String description = view.string("description");
    if (!description.isEmpty()) {
      camera.put("name", description);
    }
    ObjectNode node = out.object();
    GltfTransform.put(
        node,
        GltfTransform.vector(view.floats("position")),
        GltfTransform.rotation(view.floats("orientation")),
        new Vector3d(1));
    return node.put("camera", out.add("cameras", camera));
  }

  /**
   * Returns the node of a light that is on.
   *
   * @param scale by what the nodes around it multiply lengths, as glTF's range is one of the scene
   */
  ObjectNode light(NodeView light, double scale) {
    ObjectNode to = out.object();
    String type = light.type().name();
    to.put("type", type.substring(0, type.indexOf("Light")).toLowerCase(Locale.ROOT));
    float[] rgb = light.floats("color");
    GltfDocument.numbers(to, "color", linear(rgb[0]), linear(rgb[1]), linear(rgb[2]));
    boolean placed = !type.equals("DirectionalLight");
    boolean shines = !placed || light.number("radius") != 0; // negative: without limit
    to.put("intensity", shines ? positive(light.number("intensity"), 0) : 0);
    if (placed && light.number("radius") > 0) {
      to.put("range", positive(light.number("radius") * scale, 1));
    }
    if (type.equals("SpotLight")) {
      double outer = Math.min(positive(light.number("cutOffAngle"), Math.PI / 2), Math.PI / 2);
      double inner = positive(light.number("beamWidth"), 0);
      ObjectNode spot = to.putObject("spot").put("outerConeAngle", outer);
      spot.put("innerConeAngle", inner < outer ? inner : Math.nextDown(outer));
    }
    if (light.name() != null) {
      to.put("name", light.name());
    }
    ObjectNode lights = out.extension(out.root(), "KHR_lights_punctual");
    int index = lights.withArray("/lights").size();
    lights.withArray("/lights").add(to);
    ObjectNode node = out.object();
    Vector3d at =
        type.equals("DirectionalLight")
            ? new Vector3d()
            : GltfTransform.vector(light.floats("location"));
    Quaterniond turn = new Quaterniond();
    if (!type.equals("PointLight")) {
      Vector3d direction = GltfTransform.vector(light.floats("direction"));
      if (direction.lengthSquared() > 0 && direction.isFinite()) {
        turn.rotationTo(new Vector3d(0, 0, -1), direction);
      }
    }
    GltfTransform.put(node, at, turn, new Vector3d(1));
    out.extension(node, "KHR_lights_punctual").put("light", index);
    return node;
  }

  private static double linear(float value) {
    return Srgb.light(Math.max(0, Math.min(1, GltfDocument.finite(value))));
  }

  private static double positive(double value, double otherwise) {
    return value > 0 && Double.isFinite(value) ? value : otherwise;
  }
}
