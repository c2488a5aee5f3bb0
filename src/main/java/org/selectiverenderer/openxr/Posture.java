package org.selectiverenderer.openxr;

/** How the user of a headset holds himself. */
public enum Posture {
  /** Upright in a room whose floor the runtime knows: eyes are as high as they really are. */
  STANDING,
  /** On a chair: the eyes are as high as the scene says, wherever they are at the beginning. */
  SEATED
}
