package org.selectiverenderer.bench.versions;

/**
 * The similarity of two pictures as people judge it (Wang, Bovik, Sheikh and Simoncelli, "Image
 * quality assessment: from error visibility to structural similarity", IEEE Transactions on Image
 * Processing 13, 2004): means, variances and the covariance of grey values in a Gaussian window of
 * 11 by 11 pixels and 1.5 pixels of standard deviation are compared, with the constants of the
 * paper, and the mean is taken over all windows that lie in the picture.
 */
final class StructuralSimilarity {
  private static final int WINDOW = 11;
  private static final double DEVIATION = 1.5;
  private static final double RANGE = 255;
  private static final double C1 = 0.01 * RANGE * 0.01 * RANGE;
  private static final double C2 = 0.03 * RANGE * 0.03 * RANGE;

  private StructuralSimilarity() {}

  /**
   * Returns the similarity: 1 for equal pictures, less for others, seldom below 0.
   *
   * @param a grey values from 0 to 255, row by row
   * @param b those of the other picture, of the same size
   * @param width at least 11; so is the height
   * @throws IllegalArgumentException if the pictures are smaller, or of different sizes
   */
  static double of(double[] a, double[] b, int width) {
    int height = a.length / width;
    if (a.length != b.length || a.length != width * height || Math.min(width, height) < WINDOW) {
      throw new IllegalArgumentException(
          "two pictures of equal size are needed, of at least %d by %d pixels"
              .formatted(WINDOW, WINDOW));
    }
    double[] meanA = blurred(a, width);
    double[] meanB = blurred(b, width);
    double[] squareA = blurred(product(a, a), width);
    double[] squareB = blurred(product(b, b), width);
    double[] both = blurred(product(a, b), width);
    double sum = 0;
    for (int i = 0; i < meanA.length; i++) {
      double means = meanA[i] * meanB[i];
      double squares = meanA[i] * meanA[i] + meanB[i] * meanB[i];
      double covariance = both[i] - means;
      double variances = squareA[i] + squareB[i] - squares;
      sum += (2 * means + C1) * (2 * covariance + C2) / ((squares + C1) * (variances + C2));
    }
    return sum / meanA.length;
  }

  /**
   * Returns the grey values of a picture: its luma (ITU-R BT.601).
   *
   * @param rgba four bytes for each pixel
   */
  static double[] grey(byte[] rgba) {
    double[] grey = new double[rgba.length / 4];
    for (int i = 0; i < grey.length; i++) {
      grey[i] =
          0.299 * (rgba[4 * i] & 0xff)
              + 0.587 * (rgba[4 * i + 1] & 0xff)
              + 0.114 * (rgba[4 * i + 2] & 0xff);
    }
    return grey;
  }

  private static double[] product(double[] a, double[] b) {
    double[] product = new double[a.length];
    for (int i = 0; i < a.length; i++) {
      product[i] = a[i] * b[i];
    }
    return product;
  }

  /** Returns the weighted means of all windows inside a picture, row by row. */
  private static double[] blurred(double[] picture, int width) {
    double[] kernel = kernel();
    int height = picture.length / width;
    int across = width - WINDOW + 1;
    double[] rows = new double[across * height];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < across; x++) {
        double sum = 0;
        for (int k = 0; k < WINDOW; k++) {
          sum += kernel[k] * picture[y * width + x + k];
        }
        rows[y * across + x] = sum;
      }
    }
    double[] blurred = new double[across * (height - WINDOW + 1)];
    for (int i = 0; i < blurred.length; i++) {
      double sum = 0;
      for (int k = 0; k < WINDOW; k++) {
        sum += kernel[k] * rows[i + k * across];
      }
      blurred[i] = sum;
    }
    return blurred;
  }

  private static double[] kernel() {
    double[] kernel = new double[WINDOW];
    double sum = 0;
    for (int k = 0; k < WINDOW; k++) {
      double away = (k - WINDOW / 2) / DEVIATION;
      kernel[k] = Math.exp(-away * away / 2);
      sum += kernel[k];
    }
    for (int k = 0; k < WINDOW; k++) {
      kernel[k] /= sum;
    }
    return kernel;
  }
}
