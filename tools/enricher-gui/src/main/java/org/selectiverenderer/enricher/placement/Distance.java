package org.selectiverenderer.enricher.placement;

import org.joml.Vector3dc;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;

/** Words about the distance between two points, in metres. */
public final class Distance {
  private Distance() {}

  /** Returns the distance, and how far they are apart along each axis. */
  public static String words(Vector3dc from, Vector3dc to) {
    return Texts.of(
        "placement.measure.result",
        metres(from.distance(to)),
        metres(Math.abs(to.x() - from.x())),
        metres(Math.abs(to.y() - from.y())),
        metres(Math.abs(to.z() - from.z())));
  }

  private static String metres(double value) {
    return DecimalFormatter.fixed(value, 2);
  }
}
