package org.selectiverenderer.apartment.textures;

import org.jspecify.annotations.Nullable;

/**
 * A billboard in the landscape: an object on the ground outside, drawn as an upright image that
 * faces the flat, which is enough at its distance.
 */
interface LandscapeBillboard {
  /** Returns its direction, in turns from north over east. */
  double turn();

  /** Returns its distance, metres. */
  double distance();

  /** Returns the largest horizontal distance of its parts from its foot, metres. */
  double reach();

  /** Returns its height, metres. */
  double top();

  /**
   * Returns the display colour r, g, b at a point; null where the billboard is transparent.
   *
   * @param right metres from its foot
   * @param up metres above the ground
   */
  double @Nullable [] colour(double right, double up);
}
