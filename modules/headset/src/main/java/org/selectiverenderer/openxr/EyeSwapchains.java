package org.selectiverenderer.openxr;

import java.util.ArrayList;
import java.util.List;

/** The swapchains of both eyes, in the best texture format that the runtime supports. */
final class EyeSwapchains {
  /** Preferred formats: GL_SRGB8_ALPHA8, GL_SRGB8, GL_RGBA8. The scene is drawn in sRGB values. */
  private static final List<Integer> WANTED = List.of(0x8C43, 0x8C41, 0x8058);

  /** Index that stands for no acquired texture. */
  private static final int NONE = -1;

  private final XrSession session;
  private final RecommendedImageSize size;
  private final List<Long> chains = new ArrayList<>();
  private final List<int[]> textures = new ArrayList<>();
  private final int[] taken = {NONE, NONE};

  EyeSwapchains(XrSession session, RecommendedImageSize size) {
    this.session = session;
    this.size = size;
    int format = format(session.formats());
    for (int eye = 0; eye < taken.length; eye++) {
      long chain = session.swapchain(format, size.width(), size.height());
      chains.add(chain);
      textures.add(session.textures(chain));
    }
  }

  /**
   * Returns the best of the formats that a runtime supports. The scene's colours are sRGB values,
   * which are written unchanged; a runtime interprets the values of other formats as linear light.
   */
  static int format(List<Integer> offered) {
    return WANTED.stream()
        .filter(offered::contains)
        .findFirst()
        .orElseGet(() -> offered.isEmpty() ? WANTED.get(0) : offered.get(0));
  }

  RecommendedImageSize size() {
    return size;
  }

  /** Acquires the next texture of an eye and returns its OpenGL name. */
  int acquire(int eye) {
    int index = session.acquire(chains.get(eye));
    taken[eye] = index;
    return textures.get(eye)[index];
  }

  /** Releases the acquired textures. */
  void release() {
    for (int eye = 0; eye < taken.length; eye++) {
      if (taken[eye] != NONE) {
        taken[eye] = NONE;
        session.release(chains.get(eye));
      }
    }
  }

  /** Returns the views of a frame's projection layer. */
  List<XrSession.EyePicture> pictures(List<XrEyeView> sights) {
    List<XrSession.EyePicture> pictures = new ArrayList<>();
    for (int eye = 0; eye < taken.length; eye++) {
      pictures.add(
          new XrSession.EyePicture(chains.get(eye), size.width(), size.height(), sights.get(eye)));
    }
    return pictures;
  }
}
