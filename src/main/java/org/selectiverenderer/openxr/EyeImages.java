package org.selectiverenderer.openxr;

import java.util.ArrayList;
import java.util.List;

/** The textures of both eyes' pictures: a swapchain for each, in the best format. */
final class EyeImages {
  /** GL_SRGB8_ALPHA8, GL_SRGB8, GL_RGBA8: what the scene is drawn as already, sRGB values. */
  private static final List<Integer> WANTED = List.of(0x8C43, 0x8C41, 0x8058);

  /** A texture that was taken and not given back. */
  private static final int NONE = -1;

  private final XrSession session;
  private final PictureSize size;
  private final List<Long> chains = new ArrayList<>();
  private final List<int[]> textures = new ArrayList<>();
  private final int[] taken = {NONE, NONE};

  EyeImages(XrSession session, PictureSize size) {
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
   * The best of the formats that a runtime takes. The scene's colours are sRGB values, written as
   * they are; a runtime takes the values of other formats for linear light.
   */
  static int format(List<Integer> offered) {
    return WANTED.stream()
        .filter(offered::contains)
        .findFirst()
        .orElseGet(() -> offered.isEmpty() ? WANTED.get(0) : offered.get(0));
  }

  PictureSize size() {
    return size;
  }

  /** Takes the next texture of an eye: its OpenGL name. */
  int acquire(int eye) {
    int index = session.acquire(chains.get(eye));
    taken[eye] = index;
    return textures.get(eye)[index];
  }

  /** Gives back what was taken. */
  void release() {
    for (int eye = 0; eye < taken.length; eye++) {
      if (taken[eye] != NONE) {
        taken[eye] = NONE;
        session.release(chains.get(eye));
      }
    }
  }

  /** The layer of a frame. */
  List<XrSession.EyePicture> pictures(List<EyeSight> sights) {
    List<XrSession.EyePicture> pictures = new ArrayList<>();
    for (int eye = 0; eye < taken.length; eye++) {
      pictures.add(
          new XrSession.EyePicture(chains.get(eye), size.width(), size.height(), sights.get(eye)));
    }
    return pictures;
  }
}
