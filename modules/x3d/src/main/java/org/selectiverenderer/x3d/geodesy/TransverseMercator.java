package org.selectiverenderer.x3d.geodesy;

import org.joml.Vector2d;

/**
 * The transverse Mercator projection of a UTM zone by Krüger's series to the sixth order in the
 * third flattening, after C. F. F. Karney (Transverse Mercator with an accuracy of a few
 * nanometers, Journal of Geodesy 85, 2011, equations 10 to 36); accurate to nanometres within 3000
 * km of the central meridian.
 */
final class TransverseMercator {
  private static final double SCALE = 0.9996;
  private static final double FALSE_EASTING = 500_000;
  private static final double FALSE_NORTHING_SOUTH = 10_000_000;

  private final double centralMeridian;
  private final double falseNorthing;
  private final double eccentricity;
  private final double radius;
  private final double[] alpha;
  private final double[] beta;

  TransverseMercator(ReferenceEllipsoid ellipsoid, int zone, boolean southern) {
    centralMeridian = Math.toRadians(6 * zone - 183.0);
    falseNorthing = southern ? FALSE_NORTHING_SOUTH : 0;
    double f = ellipsoid.flattening();
    eccentricity = Math.sqrt(f * (2 - f));
    double n = f / (2 - f);
    double n2 = n * n;
    radius =
        SCALE * ellipsoid.semiMajor() / (1 + n) * (1 + n2 / 4 + n2 * n2 / 64 + n2 * n2 * n2 / 256);
    alpha =
        new double[] {
          sum(n, 1 / 2., -2 / 3., 5 / 16., 41 / 180., -127 / 288., 7891 / 37800.),
          sum(n, 0, 13 / 48., -3 / 5., 557 / 1440., 281 / 630., -1983433 / 1935360.),
          sum(n, 0, 0, 61 / 240., -103 / 140., 15061 / 26880., 167603 / 181440.),
          sum(n, 0, 0, 0, 49561 / 161280., -179 / 168., 6601661 / 7257600.),
          sum(n, 0, 0, 0, 0, 34729 / 80640., -3418889 / 1995840.),
          sum(n, 0, 0, 0, 0, 0, 212378941 / 319334400.)
        };
    beta =
        new double[] {
          sum(n, 1 / 2., -2 / 3., 37 / 96., -1 / 360., -81 / 512., 96199 / 604800.),
          sum(n, 0, 1 / 48., 1 / 15., -437 / 1440., 46 / 105., -1118711 / 3870720.),
          sum(n, 0, 0, 17 / 480., -37 / 840., -209 / 4480., 5569 / 90720.),
          sum(n, 0, 0, 0, 4397 / 161280., -11 / 504., -830251 / 7257600.),
          sum(n, 0, 0, 0, 0, 4583 / 161280., -108847 / 3991680.),
          sum(n, 0, 0, 0, 0, 0, 20648693 / 638668800.)
        };
  }

  private static double sum(double n, double... coefficients) {
    double power = n;
    double sum = 0;
    for (double coefficient : coefficients) {
      sum += coefficient * power;
      power *= n;
    }
    return sum;
  }

  /** Converts easting and northing in metres to latitude and longitude in radians. */
  Vector2d geographic(double easting, double northing) {
    double xi = (northing - falseNorthing) / radius;
    double eta = (easting - FALSE_EASTING) / radius;
    double x = xi;
    double y = eta;
    for (int j = 1; j <= beta.length; j++) {
      x -= beta[j - 1] * Math.sin(2 * j * xi) * Math.cosh(2 * j * eta);
      y -= beta[j - 1] * Math.cos(2 * j * xi) * Math.sinh(2 * j * eta);
    }
    double tau = latitudeTangent(Math.sin(x) / Math.hypot(Math.sinh(y), Math.cos(x)));
    return new Vector2d(Math.atan(tau), centralMeridian + Math.atan2(Math.sinh(y), Math.cos(x)));
  }

  /** Converts latitude and longitude in radians to easting and northing in metres. */
  Vector2d projected(double latitude, double longitude) {
    double tau = conformalTangent(Math.tan(latitude));
    double across = longitude - centralMeridian;
    double xi = Math.atan2(tau, Math.cos(across));
    double s = Math.sin(across) / Math.hypot(tau, Math.cos(across));
    double eta = Math.log(s + Math.hypot(s, 1)); // asinh
    double x = xi;
    double y = eta;
    for (int j = 1; j <= alpha.length; j++) {
      x += alpha[j - 1] * Math.sin(2 * j * xi) * Math.cosh(2 * j * eta);
      y += alpha[j - 1] * Math.cos(2 * j * xi) * Math.sinh(2 * j * eta);
    }
    return new Vector2d(FALSE_EASTING + radius * y, falseNorthing + radius * x);
  }

  /** Returns the tangent of the conformal latitude. */
  private double conformalTangent(double tau) {
    double sine = tau / Math.hypot(1, tau);
    double sigma = Math.sinh(eccentricity * atanh(eccentricity * sine));
    return tau * Math.hypot(1, sigma) - sigma * Math.hypot(1, tau);
  }

  private static double atanh(double x) {
    return Math.log((1 + x) / (1 - x)) / 2;
  }

  /** Inverts {@link #conformalTangent} by Newton's method; it converges in three steps. */
  private double latitudeTangent(double conformal) {
    double e2 = eccentricity * eccentricity;
    double tau = conformal / (1 - e2);
    for (int step = 0; step < 5; step++) {
      double at = conformalTangent(tau);
      // dτ'/dτ = (1 - e²) √(1 + τ'²) √(1 + τ²) / (1 + (1 - e²) τ²)
      tau +=
          (conformal - at)
              * (1 + (1 - e2) * tau * tau)
              / ((1 - e2) * Math.hypot(1, at) * Math.hypot(1, tau));
    }
    return tau;
  }
}
