package org.selectiverenderer.browser.camera;

/**
 * One eye's view of a frame.
 *
 * @param camera the camera and its viewport in the render target
 * @param channel the buffer and colour channels that the view is drawn into
 * @param hidden the area of the view that the display hides
 */
public record EyeView(Camera camera, Channel channel, HiddenAreaMesh hidden) {
  /** Makes a view without a hidden area. */
  public EyeView(Camera camera, Channel channel) {
    this(camera, channel, HiddenAreaMesh.NONE);
  }

  /** The buffer and colour channels that a view is drawn into. */
  public enum Channel {
    /** All colours of the default buffer. */
    ALL,
    /** The red channel only: the left eye of an anaglyph. */
    RED,
    /** The green and blue channels only: the right eye of an anaglyph. */
    CYAN,
    /** The left buffer of a quad-buffered window. */
    LEFT_BUFFER,
    /** The right buffer of a quad-buffered window. */
    RIGHT_BUFFER
  }
}
