package org.selectiverenderer.radiosity.reference;

/**
 * Spectra as linear red, green and blue of sRGB (IEC 61966-2-1).
 *
 * <p>The eye's functions are the fits of Wyman, Sloan and Shirley 2013, "Simple Analytic
 * Approximations to the CIE XYZ Color Matching Functions" (JCGT 2/2), to those of CIE 1931; the
 * daylight of 6500 K is the CIE's table of D65 (ISO/CIE 11664-2) every 10 nm. What a surface
 * reflects is seen in that daylight, so that one that reflects all is white.
 */
final class Spectrum {
  private static final int FIRST = 400;
  private static final int LAST = 700;

  /** CIE standard illuminant D65, 400 to 700 nm. */
  private static final double[] DAYLIGHT = {
    82.7549, 91.486, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923, 108.811,
    109.354, 107.802, 104.79, 107.689, 104.405, 104.046, 100, 96.3342, 95.788, 88.6856, 90.0062,
    89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091
  };

  /** From CIE X, Y, Z to linear red, green and blue. */
  private static final double[][] RGB = {
    {3.2404542, -1.5371385, -0.4985314},
    {-0.9692660, 1.8760108, 0.0415560},
    {0.0556434, -0.2040259, 1.0572252}
  };

  private final double[] values;

  /**
   * @param values evenly spread from 400 to 700 nm, straight lines between them
   */
  Spectrum(double... values) {
    this.values = values.clone();
  }

  private double at(double wavelength) {
    double place = (wavelength - FIRST) / (LAST - FIRST) * (values.length - 1);
    int below = Math.min(values.length - 2, (int) place);
    return values[below] + (place - below) * (values[below + 1] - values[below]);
  }

  /** Of a light of this spectrum, its green about its mean in the visible. */
  double[] ofLight() {
    return rgb(new Spectrum(1, 1));
  }

  /** Of a surface with this reflectance in daylight: 1, 1, 1 if it reflects all. */
  double[] ofSurface() {
    double[] rgb = rgb(new Spectrum(DAYLIGHT));
    double[] white = new Spectrum(1, 1).rgb(new Spectrum(DAYLIGHT));
    for (int i = 0; i < 3; i++) {
      rgb[i] /= white[i];
    }
    return rgb;
  }

  private double[] rgb(Spectrum light) {
    double[] xyz = new double[3];
    double white = 0;
    for (int wavelength = FIRST; wavelength <= LAST; wavelength++) {
      double power = at(wavelength) * light.at(wavelength);
      xyz[0] += power * x(wavelength);
      xyz[1] += power * y(wavelength);
      xyz[2] += power * z(wavelength);
      white += light.at(wavelength) * y(wavelength);
    }
    double[] rgb = new double[3];
    for (int row = 0; row < 3; row++) {
      rgb[row] = VectorMath.dot(RGB[row], xyz) / white;
    }
    return rgb;
  }

  private static double x(double wavelength) {
    return bell(wavelength, 0.362, 442.0, 0.0624, 0.0374)
        + bell(wavelength, 1.056, 599.8, 0.0264, 0.0323)
        + bell(wavelength, -0.065, 501.1, 0.0490, 0.0382);
  }

  private static double y(double wavelength) {
    return bell(wavelength, 0.821, 568.8, 0.0213, 0.0247)
        + bell(wavelength, 0.286, 530.9, 0.0613, 0.0322);
  }

  private static double z(double wavelength) {
    return bell(wavelength, 1.217, 437.0, 0.0845, 0.0278)
        + bell(wavelength, 0.681, 459.0, 0.0385, 0.0725);
  }

  private static double bell(double at, double height, double middle, double left, double right) {
    double t = (at - middle) * (at < middle ? left : right);
    return height * StrictMath.exp(-t * t / 2);
  }
}
