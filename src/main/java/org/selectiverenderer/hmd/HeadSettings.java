package org.selectiverenderer.hmd;

import java.util.function.BooleanSupplier;

/**
 * What is made of the place that a tracker tells of the head.
 *
 * @param placed whether it is used at all; else the tracker only turns the head
 * @param floor whether heights are above the floor that the user stands on; else above where the
 *     head was when it was last straightened
 * @param size how large the user is in the scene: 1 for one who finds it as large as it is
 */
public record HeadSettings(boolean placed, BooleanSupplier floor, double size) {
  /** A tracker that only turns the head. */
  public static final HeadSettings TURNED = new HeadSettings(false, () -> false, 1);

  /** A head whose place counts from where it was when it was last straightened. */
  public static final HeadSettings SEATED = new HeadSettings(true, () -> false, 1);
}
