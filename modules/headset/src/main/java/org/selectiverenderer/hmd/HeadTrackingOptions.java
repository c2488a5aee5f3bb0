package org.selectiverenderer.hmd;

import java.util.function.BooleanSupplier;

/**
 * Options for the use of the tracked position of the head.
 *
 * @param placed whether the position is used; otherwise only the orientation
 * @param floor whether tracked heights are above the user's floor; otherwise they count from where
 *     the head was when the tracker was last re-centred
 * @param size the size of the user relative to the scene, 1 for true scale
 */
public record HeadTrackingOptions(boolean placed, BooleanSupplier floor, double size) {
  /** Uses the orientation only. */
  public static final HeadTrackingOptions TURNED = new HeadTrackingOptions(false, () -> false, 1);

  /** Uses the position relative to where the head was when the tracker was last re-centred. */
  public static final HeadTrackingOptions SEATED = new HeadTrackingOptions(true, () -> false, 1);
}
