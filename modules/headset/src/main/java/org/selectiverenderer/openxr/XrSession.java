package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The functions of an OpenXR session. All throw {@link XrResultException}. */
interface XrSession extends AutoCloseable {
  /** The types of reference spaces, with their numbers (XrReferenceSpaceType, OpenXR 1.0, 7.1). */
  enum SpaceKind {
    VIEW(1),
    LOCAL(2),
    STAGE(3);

    private final int number;

    SpaceKind(int number) {
      this.number = number;
    }

    int number() {
      return number;
    }
  }

  /**
   * The timing of a frame: predicted display time and period in nanoseconds, and whether it is to
   * be rendered.
   */
  record FrameTime(long display, long period, boolean drawn) {}

  Set<SpaceKind> spaceKinds();

  /** Creates a reference space. */
  long space(SpaceKind kind);

  /** Locates a space in another at a time; empty while its orientation is not valid. */
  Optional<XrPose> locate(long space, long in, long time);

  /**
   * Locates a space only if its pose is tracked, not inferred. An eye tracker that does not see the
   * eyes well may still report a valid pose ({@code XR_EXT_eye_gaze_interaction}).
   */
  Optional<XrPose> tracked(long space, long in, long time);

  /**
   * Locates the views of the eyes in a space at a time, the left one first; empty while unknown.
   */
  Optional<List<XrEyeView>> eyes(long in, long time);

  /** Returns the OpenGL texture formats that the runtime supports, best first. */
  List<Integer> formats();

  long swapchain(int format, int width, int height);

  /** Returns the OpenGL names of a swapchain's textures. */
  int[] textures(long swapchain);

  /**
   * Acquires the next texture, waits until the runtime no longer reads it, and returns its index.
   */
  int acquire(long swapchain);

  void release(long swapchain);

  void begin();

  void end();

  /** Waits until the next frame is due. */
  FrameTime waitFrame();

  void beginFrame();

  /**
   * One view of a frame's projection layer.
   *
   * @param sight view with which it was rendered, in the space of the layer
   */
  record EyePicture(long swapchain, int width, int height, XrEyeView sight) {}

  /**
   * Ends a frame.
   *
   * @param space the space of the views
   * @param pictures the views of both eyes; empty to show nothing
   */
  void endFrame(long display, int blendMode, long space, List<EyePicture> pictures);

  /** Returns the visibility mask of an eye; only if the extension is enabled. */
  VisibilityMask hidden(int eye);

  @Override
  void close();
}
