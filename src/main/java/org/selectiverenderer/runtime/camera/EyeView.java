package org.selectiverenderer.runtime.camera;

/**
 * One eye's part of a frame.
 *
 * @param camera what is seen, and where in the target it is drawn
 * @param channel which buffers and colours it is drawn into
 * @param hidden what nobody sees of it
 */
public record EyeView(Camera camera, Channel channel, HiddenPart hidden) {
  /** One of which all is seen. */
  public EyeView(Camera camera, Channel channel) {
    this(camera, channel, HiddenPart.NONE);
  }

  /** Where a view's colours go. */
  public enum Channel {
    /** Into the target's usual buffer. */
    ALL,
    /** Its red only: the left eye of an anaglyph. */
    RED,
    /** Its green and blue only: the right eye of an anaglyph. */
    CYAN,
    /** Into the left buffer of a quad-buffered window. */
    LEFT_BUFFER,
    /** Into the right buffer of a quad-buffered window. */
    RIGHT_BUFFER
  }
}
