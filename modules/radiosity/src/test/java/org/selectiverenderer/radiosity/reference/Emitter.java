package org.selectiverenderer.radiosity.reference;

import org.selectiverenderer.radiosity.light.DirectionalLightSource;
import org.selectiverenderer.radiosity.light.PointLightSource;
import org.selectiverenderer.radiosity.light.RectangleLightSource;

/** A lamp as the path tracer sees it. Immutable. */
sealed interface Emitter {
  /**
   * How worthwhile a try is, from a point; 0 only where nothing can arrive.
   *
   * @param normal unit vector
   */
  double weight(double[] point, double[] normal);

  /** Draws a place of it; false when nothing arrives from there. */
  boolean draw(double[] point, double s, double t, EmitterSample draw);

  /** What lies behind a surface is worth nothing; what lies flat before it little. */
  static double before(double[] point, double[] normal, double[] centre, double radius) {
    double distance = Math.max(1e-9, VectorMath.distance(point, centre));
    double height =
        (centre[0] - point[0]) * normal[0]
            + (centre[1] - point[1]) * normal[1]
            + (centre[2] - point[2]) * normal[2];
    if (height + radius <= 0) {
      return 0;
    }
    double near = Math.max(distance, radius);
    return (0.1 + Math.max(0, height / distance)) / (near * near);
  }

  /** A point, or a spot whose light fades linearly in the cosine from beam to cut-off. */
  record Point(PointLightSource lamp) implements Emitter {
    @Override
    public double weight(double[] point, double[] normal) {
      return lamp.lumens() * before(point, normal, lamp.place(), 0);
    }

    @Override
    public boolean draw(double[] point, double s, double t, EmitterSample draw) {
      draw.aim(point, lamp.place());
      double cosine = -VectorMath.dot(draw.towards, lamp.axis());
      double full = lamp.beamCosine();
      double dark = lamp.cutOffCosine();
      double share = cosine >= full ? 1 : cosine <= dark ? 0 : (cosine - dark) / (full - dark);
      draw.density = 0;
      draw.shine(lamp.candela(), share * lamp.falloff().at(draw.distance));
      return share > 0;
    }
  }

  /** The sun. */
  record Sun(DirectionalLightSource lamp) implements Emitter {
    @Override
    public double weight(double[] point, double[] normal) {
      return lamp.lumens() * Math.max(0, VectorMath.dot(normal, lamp.towards()));
    }

    @Override
    public boolean draw(double[] point, double s, double t, EmitterSample draw) {
      System.arraycopy(lamp.towards(), 0, draw.towards, 0, 3);
      draw.distance = Double.POSITIVE_INFINITY;
      draw.density = 0;
      draw.shine(lamp.lux(), 1);
      return true;
    }
  }

  /** A rectangle that is no surface: rays pass it, and see it from its front. */
  record Rectangle(RectangleLightSource lamp, double radius) implements Emitter {
    static Rectangle of(RectangleLightSource lamp) {
      double[] a = lamp.half();
      double[] b = lamp.up();
      return new Rectangle(lamp, Math.sqrt(VectorMath.dot(a, a) + VectorMath.dot(b, b)));
    }

    private double front(double[] point) {
      double[] c = lamp.centre();
      double[] n = lamp.axis();
      return (point[0] - c[0]) * n[0] + (point[1] - c[1]) * n[1] + (point[2] - c[2]) * n[2];
    }

    @Override
    public double weight(double[] point, double[] normal) {
      double height = front(point);
      if (height <= 0) {
        return 0;
      }
      double distance = Math.max(radius, VectorMath.distance(point, lamp.centre()));
      double tilt = 0.1 + Math.min(1, height / distance);
      return lamp.lumens() * tilt * before(point, normal, lamp.centre(), radius);
    }

    @Override
    public boolean draw(double[] point, double s, double t, EmitterSample draw) {
      double[] place = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        place[axis] =
            lamp.centre()[axis] + (2 * s - 1) * lamp.half()[axis] + (2 * t - 1) * lamp.up()[axis];
      }
      double square = draw.aim(point, place);
      double cosine = -VectorMath.dot(draw.towards, lamp.axis());
      if (!(cosine > 0)) {
        return false;
      }
      draw.density = square / (lamp.area() * cosine);
      draw.shine(lamp.luminance(), 1);
      return true;
    }

    /** Where a ray crosses its front; infinite when it does not. */
    double crossing(double[] from, double[] direction) {
      double slope = VectorMath.dot(direction, lamp.axis());
      if (!(slope < 0)) {
        return Double.POSITIVE_INFINITY;
      }
      double distance = -front(from) / slope;
      if (!(distance > 0)) {
        return Double.POSITIVE_INFINITY;
      }
      double[] off = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        off[axis] = from[axis] + distance * direction[axis] - lamp.centre()[axis];
      }
      boolean in =
          Math.abs(VectorMath.dot(off, lamp.half())) <= VectorMath.dot(lamp.half(), lamp.half())
              && Math.abs(VectorMath.dot(off, lamp.up())) <= VectorMath.dot(lamp.up(), lamp.up());
      return in ? distance : Double.POSITIVE_INFINITY;
    }

    /** The density of a direction per steradian if places are drawn all over it. */
    double density(double distance, double[] direction) {
      return distance * distance / (lamp.area() * -VectorMath.dot(direction, lamp.axis()));
    }
  }

  /** A body that glows. */
  record Glow(EmissiveMesh body) implements Emitter {
    @Override
    public double weight(double[] point, double[] normal) {
      return body.lumens() * before(point, normal, body.centre(), body.radius());
    }

    @Override
    public boolean draw(double[] point, double s, double t, EmitterSample draw) {
      return body.draw(point, s, t, draw);
    }
  }
}
