package org.selectiverenderer.runtime.camera;

/** What of a headset's pictures is shown on the desk. */
public enum MirrorSide {
  /** Both eyes', side by side. */
  BOTH,
  /** The left eye's alone. */
  LEFT,
  /** The right eye's alone. */
  RIGHT
}
