package org.selectiverenderer.tracker.pipeline;

import java.io.IOException;
import org.selectiverenderer.tracker.TrackerException;

/**
 * The protocol of one kind of tracker: opens the connection and reads the records. {@link
 * LiveTracker} calls it from one thread at a time, and reopens it after a failure; so a source
 * keeps no state from one connection to the next.
 */
public interface PoseSource {
  /**
   * Opens a port or a socket, in at most about a second. A handshake that waits for the device
   * belongs into {@link #read}.
   *
   * @throws TrackerException with a message for the user
   */
  void open() throws TrackerException;

  /**
   * Reads records until the tracker is closed or has no more of them, in pieces of at most {@link
   * PoseSink#PATIENCE_MS}, and calls {@link PoseSink#tick} after each.
   *
   * @throws IOException if the connection is lost or the device violates the protocol, with a
   *     message for the user
   */
  void read(PoseSink intake) throws IOException;

  /** Returns whether the records contain the position of the head ({@link PoseSink#place}). */
  default boolean placed() {
    return false;
  }

  /** Closes the connection; does nothing if there is none. */
  void close();
}
