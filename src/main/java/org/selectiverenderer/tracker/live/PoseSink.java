package org.selectiverenderer.tracker.live;

/** Takes what a {@link PoseSource} reads; used on the tracker's thread only. */
public interface PoseSink {
  /** The longest time that a source may wait for bytes before it calls {@link #tick}. */
  int PATIENCE_MS = 50;

  /** A larger angle is no angle of a head but a broken record, in degrees. */
  double LARGEST_ANGLE = 360;

  /** A farther place is no head's but a broken record, in metres. */
  double FARTHEST = 1000;

  /** Whether the tracker is being closed: {@link PoseSource#read} is to return. */
  boolean closed();

  /** The device has answered as it should; records follow. */
  void connected();

  /**
   * A record of angles in degrees, as in {@link org.selectiverenderer.tracker.PoseSample}. Not
   * numbers and angles beyond {@link #LARGEST_ANGLE} count as bad.
   *
   * @param arrival {@link System#nanoTime} when its last byte was read
   */
  void angles(long arrival, double yaw, double pitch, double roll);

  /**
   * A record with a quaternion that takes the viewer's frame to the world's; one whose length is
   * not about 1 counts as bad.
   */
  void quaternion(long arrival, double x, double y, double z, double w);

  /**
   * The place of the head in the record that follows, in metres: right, up and back of where the
   * device counts from, along the axes of {@link org.selectiverenderer.tracker.PoseSample}. Not
   * numbers and places farther than {@link #FARTHEST} are left out.
   */
  default void place(double x, double y, double z) {}

  /** A record that had to be thrown away. */
  void bad();

  /** Called often, with or without records, so that silence is noticed. */
  void tick();
}
