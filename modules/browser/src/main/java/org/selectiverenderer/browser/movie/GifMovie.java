package org.selectiverenderer.browser.movie;

import java.util.Arrays;
import java.util.List;

/** An animated GIF; each of its frames has its own duration. */
final class GifMovie implements Movie {
  /** The disposal method: what happens to a frame's area before the next frame is drawn. */
  enum Disposal {
    STAYS,
    CLEARED,
    AS_BEFORE
  }

  /**
   * A frame, drawn over those before it.
   *
   * @param seconds the time for which the frame is shown
   */
  record Part(int left, int top, double seconds, Disposal disposal) {}

  private final byte[] file;
  private final int width;
  private final int height;
  private final boolean translucent;
  private final List<Part> parts;

  /** The end time of each frame in seconds. */
  private final double[] ends;

  GifMovie(byte[] file, int width, int height, boolean translucent, List<Part> parts) {
    this.file = file;
    this.width = width;
    this.height = height;
    this.translucent = translucent;
    this.parts = List.copyOf(parts);
    ends = new double[parts.size()];
    double sum = 0;
    for (int i = 0; i < ends.length; i++) {
      sum += parts.get(i).seconds();
      ends[i] = sum;
    }
  }

  byte[] file() {
    return file;
  }

  List<Part> parts() {
    return parts;
  }

  @Override
  public int width() {
    return width;
  }

  @Override
  public int height() {
    return height;
  }

  @Override
  public boolean translucent() {
    return translucent;
  }

  @Override
  public int pictures() {
    return ends.length;
  }

  @Override
  public double seconds() {
    return ends[ends.length - 1];
  }

  @Override
  public int at(double seconds) {
    int found = Arrays.binarySearch(ends, seconds);
    return Math.min(ends.length - 1, found < 0 ? -found - 1 : found + 1);
  }

  @Override
  public Pictures open() {
    return new GifFrameDecoder(this);
  }
}
