package org.selectiverenderer.openxr;

/** The posture of a headset's user. */
public enum Posture {
  /** Standing: heights are above the real floor, which the runtime knows (STAGE space). */
  STANDING,
  /** Seated: the eyes start at the height of the scene's viewpoint (LOCAL space). */
  SEATED
}
