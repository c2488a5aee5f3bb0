package org.selectiverenderer.tracker;

import java.util.Optional;

/**
 * A device that says where the head looks. Its records arrive on a thread of its own, at a rate of
 * its own; whoever draws reads the newest at the moment of drawing. All methods may be called from
 * any thread.
 */
public interface HeadTracker extends AutoCloseable {
  /** What was opened. */
  TrackerSpec spec();

  /**
   * Copies the newest pose, relative to the heading set by {@link #resetHeading}. Takes no lock and
   * allocates nothing.
   *
   * @param into is left as it was when there is no pose yet
   * @return whether there is one; once there was, there always is: a tracker that fell silent keeps
   *     its last pose, and {@link #health} says since when
   */
  boolean read(PoseSample into);

  /**
   * Makes the direction that the head looks in now the one with yaw 0, in software (boresight), as
   * no device is asked to. Pitch and roll stay: gravity tells them. Without a pose yet, the first
   * one will be it.
   */
  void resetHeading();

  /** How well the records arrive. Allocates; meant to be called once per frame or less. */
  TrackerHealth health();

  /** Whether it is a device that tells the place of the head, too ({@link PoseSample#placed}). */
  default boolean placed() {
    return false;
  }

  /** More about how it does, for people; empty where {@link #health} says it all. */
  default Optional<String> described() {
    return Optional.empty();
  }

  /** Lets go of the device and ends the thread; waits until that is done. A second call is none. */
  @Override
  void close();
}
