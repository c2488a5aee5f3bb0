package org.selectiverenderer.apartment.pictures;

import org.jspecify.annotations.Nullable;

/**
 * What stands on the ground outside, drawn upright to face the flat: from as far away as this one
 * sees no more of it.
 */
interface Stander {
  /** Where, in turns from north over east. */
  double turn();

  /** How far, metres. */
  double distance();

  /** No part of it is farther to the side of its foot, metres. */
  double reach();

  /** Its height, metres. */
  double top();

  /**
   * The display's red, green and blue at a place of it; null where one sees past it.
   *
   * @param right metres from its foot
   * @param up metres above the ground
   */
  double @Nullable [] colour(double right, double up);
}
