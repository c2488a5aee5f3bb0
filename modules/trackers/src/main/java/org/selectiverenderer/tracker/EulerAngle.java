package org.selectiverenderer.tracker;

/** The Euler angles of an {@link Orientation}. */
public enum EulerAngle {
  /** Rotation about Y. */
  YAW,
  /** Rotation about X. */
  PITCH,
  /** Rotation about Z. */
  ROLL
}
