package org.selectiverenderer.runtime.movie;

import java.util.Arrays;
import java.util.List;

/** An animated GIF; each of its pictures has a time of its own. */
final class GifMovie implements Movie {
  /** What becomes of the place of a picture before the next one is drawn. */
  enum Disposal {
    STAYS,
    CLEARED,
    AS_BEFORE
  }

  /**
   * A picture, drawn over those before it.
   *
   * @param seconds for which it is shown
   */
  record Part(int left, int top, double seconds, Disposal disposal) {}

  private final byte[] file;
  private final int width;
  private final int height;
  private final boolean translucent;
  private final List<Part> parts;

  /** When each part ends. */
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
    return new GifPictures(this);
  }
}
