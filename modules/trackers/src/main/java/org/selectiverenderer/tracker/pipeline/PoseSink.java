package org.selectiverenderer.tracker.pipeline;

/** Receives the records that a {@link PoseSource} reads; used on the tracker's thread only. */
public interface PoseSink {
  /**
   * Maximum time in milliseconds for which a source may wait for bytes before it calls {@link
   * #tick}.
   */
  int PATIENCE_MS = 50;

  /** Largest valid angle in degrees; a record with a larger one is corrupt. */
  double LARGEST_ANGLE = 360;

  /**
   * Largest valid distance of a position from the origin in metres; a record with a larger one is
   * corrupt.
   */
  double FARTHEST = 1000;

  /** Returns whether the tracker is being closed, so that {@link PoseSource#read} must return. */
  boolean closed();

  /** The device has answered according to its protocol; records follow. */
  void connected();

  /**
   * A record of angles in degrees, as in {@link org.selectiverenderer.tracker.PoseSample}. NaN and
   * angles beyond {@link #LARGEST_ANGLE} count as bad.
   *
   * @param arrival {@link System#nanoTime} when its last byte was read
   */
  void angles(long arrival, double yaw, double pitch, double roll);

  /**
   * A record with a quaternion that rotates the viewer's frame to the world's; one whose norm is
   * not about 1 counts as bad.
   */
  void quaternion(long arrival, double x, double y, double z, double w);

  /**
   * The position of the head in the record that follows, in metres: to the right, above and behind
   * the origin of the device, along the axes of {@link org.selectiverenderer.tracker.PoseSample}.
   * NaN and positions farther than {@link #FARTHEST} are ignored.
   */
  default void place(double x, double y, double z) {}

  /** A record was rejected. */
  void bad();

  /** Called often, with or without records, so that silence is noticed. */
  void tick();
}
