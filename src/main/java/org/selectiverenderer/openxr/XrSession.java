package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The functions of a session: pictures shown on a headset. All throw {@link XrFailure}. */
interface XrSession extends AutoCloseable {
  /** The kinds of space that everything is told in, by their numbers (OpenXR 1.0, 7.1). */
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

  /** When a frame will be seen. */
  record FrameTime(long display, long period, boolean drawn) {}

  Set<SpaceKind> spaceKinds();

  /** Makes a space of that kind. */
  long space(SpaceKind kind);

  /** Where a space is in another at a time; empty while nobody knows its orientation. */
  Optional<SpacePose> locate(long space, long in, long time);

  /**
   * The same, but empty unless the runtime vouches for it: guesses do not count. An eye tracker
   * that does not see the eyes well may still tell something ({@code XR_EXT_eye_gaze_interaction}).
   */
  Optional<SpacePose> tracked(long space, long in, long time);

  /** The eyes in a space at a time, the left one first; empty while nobody knows. */
  Optional<List<EyeSight>> eyes(long in, long time);

  /** The formats of pictures that the runtime takes, best first: numbers of OpenGL. */
  List<Integer> formats();

  long swapchain(int format, int width, int height);

  /** The textures of a swapchain. */
  int[] textures(long swapchain);

  /** Takes the next texture; returns its number once nobody else reads it. */
  int acquire(long swapchain);

  void release(long swapchain);

  void begin();

  void end();

  /** Waits until the next frame is due. */
  FrameTime waitFrame();

  void beginFrame();

  /**
   * One eye's part of a frame.
   *
   * @param sight from where it was drawn, in the space of the layer
   */
  record EyePicture(long swapchain, int width, int height, EyeSight sight) {}

  /**
   * Ends a frame.
   *
   * @param space that the eyes are told in
   * @param pictures of both eyes; empty to show nothing
   */
  void endFrame(long display, int blendMode, long space, List<EyePicture> pictures);

  /** What an eye's lens hides; only where the extension is there. */
  HiddenArea hidden(int eye);

  @Override
  void close();
}
