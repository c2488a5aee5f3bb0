package org.selectiverenderer.runtime.render.headset;

import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.runtime.camera.DepthRange;
import org.selectiverenderer.runtime.camera.ViewLayout;

/**
 * What shows frames to two eyes, at its own pace. All calls come from the thread {@code headset},
 * with its context current. None of them fails when the headset goes away: then there are no frames
 * until it is back.
 */
public interface HeadsetScreen extends AutoCloseable {
  /** Depths, in the scene's units, between which there may be something to be read. */
  DepthRange READING = new DepthRange(1e-3, 1e6);

  /** Begins to show; once, before everything else. */
  void open(ContextHandles handles);

  /**
   * A frame that is due.
   *
   * @param width of an eye's picture in pixels
   * @param height of an eye's picture in pixels
   * @param drawn whether anybody will see it
   */
  record Due(int width, int height, boolean drawn) {}

  /**
   * Waits until a frame is due. From then on the head is where it will be when that is seen.
   *
   * @return empty at once when none is due
   */
  Optional<Due> next();

  /** Whether the user sees the scene. */
  boolean visible();

  /** The views of the frame that is due: of both eyes side by side in a target. */
  ViewLayout layout();

  /** The drawing of the frame begins. */
  void begin();

  /**
   * The texture for an eye's picture.
   *
   * @param eye 0 for the left one, 1 for the right one
   */
  OptionalInt texture(int eye);

  /**
   * The frame is handed over.
   *
   * @param shown whether both pictures are there
   */
  void end(boolean shown);

  /** The runtime wants the program to end: whether that was so since the last call. */
  boolean takeLeave();

  @Override
  void close();
}
