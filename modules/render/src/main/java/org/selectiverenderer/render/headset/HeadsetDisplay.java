package org.selectiverenderer.render.headset;

import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.camera.ViewLayout;

/**
 * A headset that shows frames to two eyes at its own pace. All calls come from the thread {@code
 * headset}, with its context current. None of them fails when the headset is disconnected: then no
 * frames are due until it is back.
 */
public interface HeadsetDisplay extends AutoCloseable {
  /** The depth range, in the scene's units, for panels of text. */
  DepthRange READING = new DepthRange(1e-3, 1e6);

  /** Opens the headset; called once, before everything else. */
  void open(GlContextHandles handles);

  /**
   * A frame that is due.
   *
   * @param width of an eye's picture in pixels
   * @param height of an eye's picture in pixels
   * @param drawn whether the frame will be displayed, and so should be drawn
   */
  record Due(int width, int height, boolean drawn) {}

  /**
   * Waits until a frame is due. From then on the head's pose is the one predicted for the time at
   * which that frame is displayed.
   *
   * @return empty at once when none is due
   */
  Optional<Due> next();

  /** Returns whether the user sees the scene. */
  boolean visible();

  /** Returns the layout of the frame that is due: both eyes side by side in one framebuffer. */
  ViewLayout layout();

  /** Called when the drawing of the frame begins. */
  void begin();

  /**
   * Returns the texture for an eye's picture.
   *
   * @param eye 0 for the left one, 1 for the right one
   */
  OptionalInt texture(int eye);

  /**
   * Submits the frame.
   *
   * @param shown whether both eyes' pictures were copied
   */
  void end(boolean shown);

  /** Returns whether the runtime has asked the program to end since the last call. */
  boolean takeLeave();

  @Override
  void close();
}
