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
   * What this participant saw and did altogether, for a size exponent: what is expected of an
   * object is its share of it.
   *
   * @param exponent of the solid angle to which attention is expected to be proportional
   * @param exposure sum over the objects of time in view times size
   * @param waiting likewise, until the first look
   */
  record Totals(
      double exponent, double exposure, double waiting, double dwell, double looks, double found) {}

  Totals totals(double exponent) {
    return new Totals(
        exponent,
        sum(object -> exposure(object, exponent)),
        sum(object -> waiting(object, exponent)),
        sum(ObjectAttention::dwell),
        sum(ObjectAttention::looks),
        sum(ObjectAttention::found));
  }

  /**
   * Returns how often an object was attended relative to what its time in view and its size let
   * expect, as a natural logarithm: the weighted mean of those of three rates, each (observed +
   * 1/2) / (expected + 1/2). They are the dwell time, counted in this participant's mean looks; the
   * looks; and whether there was a first look in the time that the object waited for one, which is
   * censored where there was none.
   */
  double relativeAttention(ObjectAttention object, Totals totals) {
    double mean = totals.looks > 0 ? totals.dwell / totals.looks : 1;
    double expected = expectedLooks(object, totals);
    double first =
        totals.waiting > 0 ? totals.found * waiting(object, totals.exponent) / totals.waiting : 0;
    return (DWELL * rate(object.dwell() / mean, expected)
            + LOOKS * rate(object.looks(), expected)
            + FIRST * rate(object.found(), first))
        / OF_DWELL;
  }

  /** Returns the number of looks that time in view and size of an object let expect. */
  double expectedLooks(ObjectAttention object, Totals totals) {
    return totals.exposure > 0
        ? totals.looks * exposure(object, totals.exponent) / totals.exposure
        : 0;
  }

  private double sum(ToDoubleFunction<ObjectAttention> value) {
    return objects.values().stream().mapToDouble(value).sum();
  }

  /**
   * Returns the time in which an object could have been looked at and was not, times its size: with
   * the looks themselves, what is looked at would have been in view the longer for it.
   */
  private static double exposure(ObjectAttention object, double exponent) {
    double free = Math.max(object.inView() - object.dwell(), 0);
    return free * Math.pow(object.meanSolidAngle(), exponent);
  }

  private static double waiting(ObjectAttention object, double exponent) {
    return object.waited() * Math.pow(object.meanSolidAngle(), exponent);
  }

  private static double rate(double observed, double expected) {
    return Math.log((observed + 0.5) / (expected + 0.5));
  }
}
