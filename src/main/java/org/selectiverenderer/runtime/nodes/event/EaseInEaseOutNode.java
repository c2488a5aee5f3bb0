package org.selectiverenderer.runtime.nodes.event;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Speeds up after a key and slows down before the next one (X3D 4.0, 19.4.4). */
public final class EaseInEaseOutNode extends Node {
  private final int fraction;
  private final int key;
  private final int ease;
  private final int modified;

  public EaseInEaseOutNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    fraction = type.indexOf("set_fraction");
    key = type.indexOf("key");
    ease = type.indexOf("easeInEaseOut");
    modified = type.indexOf("modifiedFraction_changed");
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (field.index() != fraction) {
      super.receive(field, value, cascade);
      return;
    }
    float at = (Float) value;
    float[] keys = (float[]) value(key);
    float[] eases = (float[]) value(ease);
    int count = Math.min(keys.length, eases.length / 2);
    if (count == 0 || Float.isNaN(at)) {
      return;
    }
    int low = KeyFrames.at(keys, count, at);
    if (low == count - 1 || at <= keys[low]) {
      emit(modified, low == count - 1 && count > 1 ? 1f : 0f, cascade);
      return;
    }
    float part = (at - keys[low]) / (keys[low + 1] - keys[low]);
    emit(modified, (float) eased(part, eases[2 * low + 1], eases[2 * low + 2]), cascade);
  }

  /**
   * @param out the part of the interval in which it speeds up
   * @param in the part in which it slows down
   */
  private static double eased(double part, double out, double in) {
    double sum = out + in;
    if (sum <= 0) {
      return part;
    }
    double easeOut = sum > 1 ? out / sum : out;
    double easeIn = sum > 1 ? in / sum : in;
    double t = 1 / (2 - easeOut - easeIn);
    if (part < easeOut) {
      return t / easeOut * part * part;
    }
    if (part <= 1 - easeIn) {
      return t * (2 * part - easeOut);
    }
    return 1 - t * (1 - part) * (1 - part) / easeIn;
  }
}
