package org.selectiverenderer.apparatus;

/** The output of a run ({@code run --display}). */
public enum DisplayMode {
  /** One view in a window. */
  WINDOW,
  /** Both eyes in one window, left and right. */
  SIDE_BY_SIDE,
  /** A full-screen window for each eye, on two monitors. */
  DUAL,
  /** Both eyes through a graphics card with quad-buffered stereo. */
  QUAD,
  /** Both eyes in one picture for red and cyan glasses. */
  ANAGLYPH,
  /** A headset that an OpenXR runtime drives. */
  OPENXR
}
