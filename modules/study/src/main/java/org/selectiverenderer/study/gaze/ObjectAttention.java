package org.selectiverenderer.study.gaze;

/**
 * What one participant saw of one object in one area.
 *
 * @param inView seconds in which the object was in view
 * @param solidAngle integral of its solid angle over that time, in steradians times seconds; that
 *     time itself where the log does not tell where objects are
 * @param waited seconds in view until the first look, or to the end where there was none
 * @param found number of recordings in which it was looked at; 0 where the time until the first
 *     look is censored
 * @param dwell seconds in which it was looked at
 * @param looks number of looks at it
 * @param fixations number of fixations of the eyes; of looks in a log without gaze data
 */
record ObjectAttention(
    double inView,
    double solidAngle,
    double waited,
    int found,
    double dwell,
    int looks,
    int fixations) {
  /** Returns the sum of what was seen in two recordings. */
  ObjectAttention plus(ObjectAttention other) {
    return new ObjectAttention(
        inView + other.inView,
        solidAngle + other.solidAngle,
        waited + other.waited,
        found + other.found,
        dwell + other.dwell,
        looks + other.looks,
        fixations + other.fixations);
  }

  /** Returns the mean solid angle while the object was in view, in steradians. */
  double meanSolidAngle() {
    return solidAngle / inView;
  }
}
