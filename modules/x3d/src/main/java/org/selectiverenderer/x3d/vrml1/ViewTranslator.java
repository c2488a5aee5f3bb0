package org.selectiverenderer.x3d.vrml1;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field.Form;

/** Translates lights, cameras, surroundings, links to other files, and Info. */
final class ViewTranslator {
  /** Lights of VRML 1.0 reach everything; those of X3D reach as far as their radius. */
  private static final String UNLIMITED = "1000000";

  /** The exponent of OpenGL for a dropOffRate of 1. */
  private static final double LARGEST_EXPONENT = 128;

  private static final double RIGHT_ANGLE = Math.PI / 2;

  private static final Pattern COLOUR =
      Pattern.compile("\\s*(0|1|[01]?\\.\\d+)(\\s+(0|1|[01]?\\.\\d+)){2}\\s*");

  private final ElementTreeBuilder document;
  private final Vrml1Values values;
  private boolean orthographic;

  ViewTranslator(ElementTreeBuilder document, Vrml1Values values) {
    this.document = document;
    this.values = values;
  }

  /** Returns whether there has been an OrthographicCamera. */
  boolean orthographic() {
    return orthographic;
  }

  static boolean isCamera(String type) {
    return type.equals("PerspectiveCamera") || type.equals("OrthographicCamera");
  }

  private void copy(X3dElement element, Vrml1Node node, String... fields) {
    for (String name : fields) {
      Field field = node.field(name);
      if (field != null) {
        element.set(name, values.brief(field), field);
      }
    }
  }

  /**
   * Translates a light.
   *
   * @param matrix transforms its location and direction; null if these are kept as they are written
   */
  X3dElement light(Vrml1Node node, String type, @Nullable Matrix4dc matrix) {
    X3dElement light = X3dElement.of(type, node);
    if (matrix == null) {
      if (node.field("location") == null && !type.equals("DirectionalLight")) {
        light.set("location", "0 0 1", node.typeAt());
      }
      copy(light, node, "location", "direction");
    } else {
      place(light, node, matrix);
    }
    copy(light, node, "color", "intensity");
    Field on = node.field("on");
    if (on != null && (values.word(node, "on").equals("FALSE") || values.text(on).equals("0"))) {
      light.set("on", "false", on);
    }
    if (type.equals("SpotLight")) {
      cone(light, node);
    }
    if (!type.equals("DirectionalLight")) {
      light.set("global", "false", node.typeAt()).set("radius", UNLIMITED, node.typeAt());
    }
    return light;
  }

  private void place(X3dElement light, Vrml1Node node, Matrix4dc matrix) {
    if (!light.name().equals("DirectionalLight")) {
      float[] p = values.numbers(node, "location", 0, 0, 1);
      Vector3d place = matrix.transformPosition(new Vector3d(p[0], p[1], p[2]));
      light.set("location", Vrml1Values.tuple(place.x, place.y, place.z), node.typeAt());
    }
    if (!light.name().equals("PointLight")) {
      float[] d = values.numbers(node, "direction", 0, 0, -1);
      Vector3d along = matrix.transformDirection(new Vector3d(d[0], d[1], d[2]));
      light.set("direction", Vrml1Values.tuple(along.x, along.y, along.z), node.typeAt());
    }
  }

  /**
   * Translates the exponential loss of light away from the axis into X3D's linear one, so that both
   * have half of the light at the same angle.
   */
  private void cone(X3dElement light, Vrml1Node node) {
    double cutOff = values.numbers(node, "cutOffAngle", 0.785398f)[0];
    cutOff = Math.min(RIGHT_ANGLE, Math.max(0.001, cutOff));
    double exponent = LARGEST_EXPONENT * values.numbers(node, "dropOffRate", 0)[0];
    double half = exponent > 0 ? Math.acos(Math.pow(0.5, 1 / exponent)) : cutOff;
    double beam = Math.min(cutOff, Math.max(0.001, 2 * half - cutOff));
    light.set("cutOffAngle", Vrml1Values.number(cutOff), node.typeAt());
    light.set("beamWidth", Vrml1Values.number(beam), node.typeAt());
  }

  X3dElement camera(Vrml1Node node, String type) {
    boolean flat = type.equals("OrthographicCamera");
    orthographic |= flat;
    X3dElement viewpoint = X3dElement.of(flat ? "OrthoViewpoint" : "Viewpoint", node);
    node.name().ifPresent(name -> viewpoint.set("description", name, node.typeAt()));
    if (node.field("position") == null) {
      viewpoint.set("position", "0 0 1", node.typeAt());
    }
    copy(viewpoint, node, "position", "orientation");
    centre(viewpoint, node);
    Field angle = node.field("heightAngle");
    if (flat && node.field("height") != null) {
      double half = values.numbers(node, "height", 2)[0] / 2;
      viewpoint.set("fieldOfView", Vrml1Values.tuple(-half, -half, half, half), node.typeAt());
    } else if (!flat && angle != null) {
      viewpoint.set("fieldOfView", values.text(angle).strip(), angle);
    }
    return viewpoint;
  }

  /** Sets the point that the viewer examines, which is where the camera is focused. */
  private void centre(X3dElement viewpoint, Vrml1Node node) {
    Field focus = node.field("focalDistance");
    if (focus == null) {
      return;
    }
    float[] p = values.numbers(node, "position", 0, 0, 1);
    float[] r = values.numbers(node, "orientation", 0, 0, 1, 0);
    Vector3d ahead = new Vector3d(0, 0, -values.numbers(node, "focalDistance", 5)[0]);
    if (r[0] != 0 || r[1] != 0 || r[2] != 0) {
      new Quaterniond().rotationAxis(r[3], r[0], r[1], r[2]).transform(ahead);
    }
    viewpoint.set(
        "centerOfRotation",
        Vrml1Values.tuple(p[0] + ahead.x, p[1] + ahead.y, p[2] + ahead.z),
        focus);
  }

  /** Translates a node whose fields are those of VRML97. */
  X3dElement environment(Vrml1Node node, String type, List<String> fields) {
    X3dElement element = X3dElement.of(type, node);
    for (Map.Entry<String, Field> entry : node.fields().entrySet()) {
      String name = entry.getKey();
      Field field = entry.getValue();
      if (fields.contains(name)) {
        String value =
            switch (name) {
              case "headlight" -> values.word(node, name).toLowerCase(Locale.ROOT);
              case "fogType" -> values.string(node, name);
              default ->
                  field.form() == Form.STRING ? values.strings(field) : values.text(field).strip();
            };
        element.set(name, value, field);
      }
    }
    return element;
  }

  /**
   * Returns what an Info says: the background and the navigation, as viewers of VRML 1.0 agreed
   * upon by names, else a WorldInfo; null if it says nothing.
   */
  @Nullable X3dElement information(Vrml1Node node) {
    Field field = node.field("string");
    String words = values.string(node, "string");
    if (field == null || words.isEmpty()) {
      return null;
    }
    String name = node.name().orElse("");
    if (name.equals("BackgroundColor") && COLOUR.matcher(words).matches()) {
      return X3dElement.of("Background", node).set("skyColor", words.strip(), field);
    }
    String type =
        switch (name.equals("Viewer") ? words.strip().toLowerCase(Locale.ROOT) : "") {
          case "examiner" -> "EXAMINE";
          case "walk" -> "WALK";
          case "fly", "plane" -> "FLY";
          default -> "";
        };
    if (!type.isEmpty()) {
      return X3dElement.of("NavigationInfo", node)
          .set("type", FieldTokenizer.string(type) + " \"ANY\"", field);
    }
    String kind = name.equals("Title") ? "title" : "info";
    String text = kind.equals("title") ? words : FieldTokenizer.string(words);
    return X3dElement.of("WorldInfo", node).set(kind, text, field);
  }

  /** Sets the fields of an Anchor. */
  void anchor(X3dElement anchor, Vrml1Node node) {
    Field url = node.field("name");
    if (url != null) {
      anchor.set("url", FieldTokenizer.string(values.string(node, "name")), url);
    }
    Field description = node.field("description");
    if (description != null) {
      anchor.set("description", values.string(node, "description"), description);
    }
    Field map = node.field("map");
    if (map != null && values.word(node, "map").equals("POINT")) {
      document.leftOut(
          map.at(), "X3D has no word for 'map POINT'; the Anchor does not send the point");
    }
  }

  X3dElement inline(Vrml1Node node) {
    X3dElement inline = X3dElement.of("Inline", node);
    Field url = node.field("name");
    if (url != null) {
      inline.set("url", FieldTokenizer.string(values.string(node, "name")), url);
    }
    float[] size = values.numbers(node, "bboxSize", 0, 0, 0);
    if (size[0] > 0 || size[1] > 0 || size[2] > 0) {
      for (String name : new String[] {"bboxCenter", "bboxSize"}) {
        Field field = node.field(name);
        if (field != null) {
          inline.set(name, values.text(field).strip(), field);
        }
      }
    }
    return inline;
  }
}
