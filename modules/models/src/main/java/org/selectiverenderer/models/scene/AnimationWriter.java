package org.selectiverenderer.models.scene;

import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes animations as TimeSensors and interpolators with routes. The first animation runs in a
 * loop, as viewers of models show it; the TimeSensors of others wait for {@code enabled}.
 */
public final class AnimationWriter {
  private final X3dWriter out;
  private final DefNames names;
  private final AnimatedNodes nodes;
  private String clock = "";
  private double duration;
  private boolean first = true;

  /** Creates a writer for the animations of nodes that have been written. */
  public AnimationWriter(X3dWriter out, DefNames names, AnimatedNodes nodes) {
    this.out = out;
    this.names = names;
    this.nodes = nodes;
  }

  /**
   * Begins an animation.
   *
   * @param name its name in the model, or ""
   * @param otherwise the DEF name if it has none
   * @param seconds its duration, more than 0
   */
  public void begin(String name, String otherwise, double seconds) {
    clock = names.unique(name, otherwise);
    duration = seconds;
    out.open("TimeSensor", "DEF", clock, "cycleInterval", Numbers.of(seconds), "loop", "true");
    if (!name.isBlank()) {
      out.attribute("description", XmlText.of(name));
    }
    if (!first) {
      out.attribute("enabled", "false");
    }
    out.close();
    first = false;
  }

  /**
   * Writes what moves a node.
   *
   * @param node the model's node
   * @param field translation, rotation (as unit quaternions x, y, z, w) or scale
   */
  public void move(int node, String field, Keyframes keys) {
    boolean turns = field.equals("rotation");
    String type = turns ? "OrientationInterpolator" : "PositionInterpolator";
    Map<JointBinding, String> interpolators = new HashMap<>();
    for (AnimatedNodes.Written written : nodes.of(node)) {
      String interpolator = interpolators.get(written.binding());
      if (interpolator == null) {
        float[] values = values(field, keys, written.binding());
        interpolator = interpolator(type, keys, values, written.def() + "_" + field);
        interpolators.put(written.binding(), interpolator);
      }
      out.route(interpolator, "value_changed", written.def(), field);
    }
  }

  /**
   * Writes what changes a field of a node that is no part of the tree, such as the points of a
   * Coordinate.
   *
   * @param type the type of the interpolator
   * @param keys the times
   * @param values the values at these times
   * @param def the DEF name of the node
   */
  public void change(String type, Keyframes keys, float[] values, String def, String field) {
    String interpolator = interpolator(type, keys, values, def + "_" + field);
    out.route(interpolator, "value_changed", def, field);
  }

  private String interpolator(String type, Keyframes keys, float[] values, String name) {
    String def = names.unique("", name);
    out.open(type, "DEF", def);
    out.ownLine().numbers("key", Numbers.list(keys.fractions(duration)));
    out.ownLine().numbers("keyValue", Numbers.list(values)).close();
    out.route(clock, "fraction_changed", def, "set_fraction");
    return def;
  }

  private static float[] values(String field, Keyframes keys, JointBinding binding) {
    int size = keys.size();
    float[] values = new float[keys.values().length];
    for (int i = 0; i < keys.times().length; i++) {
      float[] v = keys.value(i);
      double[] value =
          switch (field) {
            case "rotation" -> {
              double[] q = NodeTransform.unit(new double[] {v[0], v[1], v[2], v[3]});
              yield binding.rotation(q[0], q[1], q[2], q[3]);
            }
            case "scale" -> binding.scale(v[0], v[1], v[2]);
            default -> binding.translation(v[0], v[1], v[2]);
          };
      for (int k = 0; k < size; k++) {
        values[size * i + k] = (float) value[k];
      }
    }
    return values;
  }
}
