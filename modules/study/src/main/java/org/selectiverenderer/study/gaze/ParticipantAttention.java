package org.selectiverenderer.study.gaze;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;

/**
 * What a participant saw of the objects in an area; of those that were in view long enough to be
 * looked at.
 */
record ParticipantAttention(
    String participant, GazeArea area, Map<String, ObjectAttention> objects) {
  /** Seconds in view below which an object is left out. */
  private static final double SHORTEST = 1;

  /**
   * Weights of the three rates. That dwell is longer on inconsistent objects is found throughout;
   * that they are looked at earlier is not (Henderson et al. 1999, Vo and Henderson 2009).
   */
  private static final double DWELL = 0.5;

  private static final double LOOKS = 0.25;
  private static final double FIRST = 0.25;

  /**
   * What the weighted mean is of the logarithm of the dwell's rate where number and length of looks
   * each rise by the square root of it; division by it gives the dwell's own scale.
   */
  private static final double OF_DWELL = DWELL + (LOOKS + FIRST) / 2;

  ParticipantAttention {
    Map<String, ObjectAttention> seen = new TreeMap<>(objects); // the same order every time
    seen.values().removeIf(object -> object.inView() < SHORTEST || !(object.solidAngle() > 0));
    objects = Collections.unmodifiableMap(seen);
  }

  /**
   * Returns how often an object was attended relative to what its time in view and its size let
   * expect, as a natural logarithm: the weighted mean of those of three rates, each (observed + 1/2)
   * / (expected + 1/2). They are the dwell time, counted in this participant's mean looks; the
   * looks; and whether there was a first look in the time that the object waited for one, which is
   * censored where there was none.
   *
   * @param exponent of the solid angle to which attention is expected to be proportional
   */
  double relativeAttention(String name, double exponent) {
    ObjectAttention object = objects.get(name);
    double exposure = exposure(object, exponent);
    double all = objects.values().stream().mapToDouble(one -> exposure(one, exponent)).sum();
    double looks = sum(ObjectAttention::looks);
    double dwell = sum(ObjectAttention::dwell);
    double waited =
        objects.values().stream().mapToDouble(one -> waited(one, exponent)).sum();
    double found = sum(ObjectAttention::found);
    double mean = looks > 0 ? dwell / looks : 1;
    double ofDwell = rate(object.dwell() / mean, dwell / mean * exposure / all);
    double ofLooks = rate(object.looks(), looks * exposure / all);
    double ofFirst =
        rate(object.found(), waited > 0 ? found * waited(object, exponent) / waited : 0);
    return (DWELL * ofDwell + LOOKS * ofLooks + FIRST * ofFirst) / OF_DWELL;
  }

  /** Returns the number of looks that time in view and size of an object let expect. */
  double expectedLooks(String name, double exponent) {
    double all = objects.values().stream().mapToDouble(one -> exposure(one, exponent)).sum();
    return sum(ObjectAttention::looks) * exposure(objects.get(name), exponent) / all;
  }

  private double sum(ToDoubleFunction<ObjectAttention> value) {
    return objects.values().stream().mapToDouble(value).sum();
  }

  private static double exposure(ObjectAttention object, double exponent) {
    double before = Math.max(object.inView() - object.dwell(), 0);
    return before * Math.pow(object.meanSolidAngle(), exponent);
  }

  private static double waited(ObjectAttention object, double exponent) {
    return object.waited() * Math.pow(object.meanSolidAngle(), exponent);
  }

  private static double rate(double observed, double expected) {
    return Math.log((observed + 0.5) / (expected + 0.5));
  }
}
