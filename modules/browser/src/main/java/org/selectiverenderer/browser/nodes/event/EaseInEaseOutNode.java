package org.selectiverenderer.browser.nodes.event;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * EaseInEaseOut: modifies a fraction so that motion speeds up after a key and slows down before the
 * next (X3D 4.0, 19.4.4).
 */
public final class EaseInEaseOutNode extends KeyframeNode {
  private final int ease;
  private final int modified;

  public EaseInEaseOutNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    ease = type.indexOf("easeInEaseOut");
    modified = type.indexOf("modifiedFraction_changed");
  }

  @Override
  protected int values() {
    return ((float[]) value(ease)).length / 2;
  }

  @Override
  protected void send(int low, int count, float part, EventCascade cascade) {
    if (part == 0) {
      emit(modified, low == count - 1 && count > 1 ? 1f : 0f, cascade);
      return;
    }
    float[] eases = (float[]) value(ease);
    emit(modified, (float) eased(part, eases[2 * low + 1], eases[2 * low + 2]), cascade);
  }

  /**
   * @param out the part of the interval in which the motion speeds up
   * @param in the part of the interval in which the motion slows down
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
