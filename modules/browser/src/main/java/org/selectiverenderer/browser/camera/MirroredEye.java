package org.selectiverenderer.browser.camera;

/** The eyes of a headset whose pictures the mirror window on the desktop shows. */
public enum MirroredEye {
  /** Both eyes, side by side. */
  BOTH,
  /** The left eye only. */
  LEFT,
  /** The right eye only. */
  RIGHT
}
