package org.selectiverenderer.tracker;

/** The angles of an {@link Orientation}. */
public enum Axis {
  /** About Y. */
  YAW,
  /** About X. */
  PITCH,
  /** About Z. */
  ROLL
}
