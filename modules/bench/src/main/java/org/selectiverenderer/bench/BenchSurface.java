package org.selectiverenderer.bench;

import static java.lang.Math.PI;
import static java.lang.Math.abs;
import static java.lang.Math.cos;
import static java.lang.Math.pow;
import static java.lang.Math.signum;
import static java.lang.Math.sin;

/**
 * The parametric shapes of the benchmark's objects: closed surfaces over (u, v), both in 0..1,
 * about 0.8 m large around the origin, +Y up. The phase varies each shape.
 */
enum BenchSurface {
  VASE(false) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double radius = sin(PI * u) * (0.24 + 0.1 * sin(2 * PI * u * 1.3 + phase));
      round(radius * (1 + 0.04 * cos(16 * PI * v)), -0.4 * cos(PI * u), v, out);
    }
  },
  BUMPY_BALL(false) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double bump = 1 + 0.07 * sin(9 * PI * u + phase) * sin(10 * PI * v);
      round(0.36 * bump * sin(PI * u), -0.36 * bump * cos(PI * u), v, out);
    }
  },
  RING(true) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double tube = 0.1 + 0.025 * sin(14 * PI * u + phase);
      round(0.28 + tube * cos(2 * PI * v), tube * sin(2 * PI * v), u, out);
    }
  },
  ROUNDED_BOX(false) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double e = 0.35 + 0.1 * sin(phase);
      double latitude = PI * (u - 0.5);
      double around = 2 * PI * v;
      out[0] = 0.3 * bent(cos(latitude), e) * bent(cos(around), e);
      out[1] = 0.4 * bent(sin(latitude), e);
      out[2] = -0.26 * bent(cos(latitude), e) * bent(sin(around), e);
    }
  },
  COLUMN(false) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double twisted = v + 0.6 * u + phase;
      double radius = pow(sin(PI * u), 0.25) * (0.2 + 0.03 * cos(12 * PI * twisted));
      round(radius, -0.4 * cos(PI * u), v, out);
    }
  },
  KNOT(true) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double a = 2 * PI * u;
      double tube = 2 * PI * v;
      double large = 0.22 + 0.09 * cos(3 * a);
      // The tube's cross-section stands upright and radial: enough for a knot as slender as this.
      double radius = large + 0.06 * cos(tube);
      out[0] = radius * cos(2 * a + phase);
      out[1] = 0.12 * sin(3 * a) + 0.06 * sin(tube);
      out[2] = -radius * sin(2 * a + phase);
    }
  },
  CLOVER(true) {
    @Override
    void point(double u, double v, double phase, double[] out) {
      double lobes = 0.26 + 0.07 * cos(8 * PI * u + phase);
      round(lobes + 0.08 * cos(2 * PI * v), 0.2 * sin(2 * PI * v), u, out);
    }
  };

  private final boolean ring;

  BenchSurface(boolean ring) {
    this.ring = ring;
  }

  /** Returns whether u is periodic as v is; otherwise u = 0 and u = 1 are poles. */
  boolean isRing() {
    return ring;
  }

  abstract void point(double u, double v, double phase, double[] out);

  private static void round(double radius, double height, double turn, double[] out) {
    out[0] = radius * cos(2 * PI * turn);
    out[1] = height;
    out[2] = -radius * sin(2 * PI * turn);
  }

  private static double bent(double value, double exponent) {
    return signum(value) * pow(abs(value), exponent);
  }
}
