package org.selectiverenderer.tracker.live;

import java.io.IOException;
import org.selectiverenderer.tracker.TrackerException;

/**
 * One kind of tracker: opens its connection and reads its records. {@link LiveTracker} calls it
 * from one thread at a time, and opens it again after it failed; so a source keeps nothing from one
 * connection to the next.
 */
public interface PoseSource {
  /**
   * Opens what can be opened at once, in at most about a second: a port, a socket. Hand-shakes that
   * wait for a device belong into {@link #read}.
   *
   * @throws TrackerException with a sentence that says what is wrong
   */
  void open() throws TrackerException;

  /**
   * Reads records until the tracker is closed or has no more of them, in pieces of at most {@link
   * PoseSink#PATIENCE_MS}, and calls {@link PoseSink#tick} after each.
   *
   * @throws IOException if the connection is lost or the device does not answer as it should, with
   *     a sentence
   */
  void read(PoseSink intake) throws IOException;

  /** Whether its records tell the place of the head ({@link PoseSink#place}). */
  default boolean placed() {
    return false;
  }

  /** Lets go of the connection; does nothing when there is none. */
  void close();
}
