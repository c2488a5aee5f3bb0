package org.selectiverenderer.x3d.field;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** Validates SFImage and MFImage values: width, height, components, then the pixels. */
final class ImageValidator {
  private static final int HEAD = 3;

  private ImageValidator() {}

  /** Returns the numbers of the complete images, or null if there is none. */
  static int @Nullable [] check(int[] numbers, boolean several, FieldParseErrors flaws) {
    int at = 0;
    while (at < numbers.length) {
      if (at > 0 && !several) {
        flaws.error(0, "the image has more numbers than pixels; the rest is left out");
        return Arrays.copyOf(numbers, at);
      }
      int left = numbers.length - at - HEAD;
      if (left < 0 || numbers[at] < 0 || numbers[at + 1] < 0) {
        flaws.error(
            0,
            "an image must start with its width, height and number of components; it "
                + "is left out");
        return several ? Arrays.copyOf(numbers, at) : null;
      }
      int components = numbers[at + 2];
      if (components < 0 || components > 4) {
        flaws.error(
            0, "an image must have 0 to 4 components, not " + components + "; it is left out");
        return several ? Arrays.copyOf(numbers, at) : null;
      }
      long pixels = (long) numbers[at] * numbers[at + 1];
      if (pixels > left) {
        int rows = left / numbers[at];
        flaws.error(
            0,
            "the image has only "
                + left
                + " of its "
                + pixels
                + " pixels; its first "
                + rows
                + " rows are shown");
        int[] kept = Arrays.copyOf(numbers, at + HEAD + rows * numbers[at]);
        kept[at + 1] = rows;
        return kept;
      }
      at += HEAD + (int) pixels;
    }
    if (numbers.length == 0 && !several) {
      flaws.error(
          0,
          "an image must start with its width, height and number of components; it "
              + "is left out");
      return null;
    }
    return numbers;
  }
}
