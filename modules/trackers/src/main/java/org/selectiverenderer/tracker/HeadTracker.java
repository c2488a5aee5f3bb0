package org.selectiverenderer.tracker;

import java.util.Optional;

/**
 * A head tracker: a device that measures the orientation, and perhaps the position, of the head.
 * Its records arrive on a separate thread at the device's rate; the renderer reads the latest pose
 * when it draws. Thread-safe.
 */
public interface HeadTracker extends AutoCloseable {
  /** Returns the SPEC of the tracker. */
  TrackerSpec spec();

  /**
   * Copies the latest pose, relative to the heading set by {@link #resetHeading}. Takes no lock and
   * allocates nothing.
   *
   * @param into receives the pose; unchanged if there is no pose yet
   * @return whether there is a pose; once there was one, there always is: a silent tracker keeps
   *     its last pose, and {@link #health} tells since when
   */
  boolean read(PoseSample into);

  /**
   * Resets the heading (boresight): the present heading gets yaw 0. This is done in software,
   * without a command to the device. Pitch and roll, which gravity determines, do not change.
   * Before the first pose, the reset applies to the first pose.
   */
  void resetHeading();

  /** Returns statistics of the records. Allocates; meant to be called once per frame or less. */
  TrackerHealth health();

  /**
   * Returns whether the device measures the position of the head, too ({@link PoseSample#placed}).
   */
  default boolean placed() {
    return false;
  }

  /** Returns further status information for people; empty if {@link #health} is complete. */
  default Optional<String> described() {
    return Optional.empty();
  }

  /** Closes the device and waits for the end of the thread; a second call does nothing. */
  @Override
  void close();
}
