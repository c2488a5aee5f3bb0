package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;

/**
 * Reads the messages of a VRPN server. Each has a header of 24 bytes (length of header and payload,
 * time in seconds and microseconds, sender, type, sequence; 32-bit integers), then the payload,
 * padded to a multiple of 8. The server numbers its senders and types by descriptions, which come
 * first.
 */
final class VrpnMessageReader {
  private static final int HEADER = 24;
  private static final int SENDER_DESCRIPTION = -1;
  private static final int TYPE_DESCRIPTION = -2;
  private static final String POSE = "vrpn_Tracker Pos_Quat";

  /** Sensor number and padding, three doubles of the position, then the quaternion x, y, z, w. */
  private static final int POSE_LENGTH = 8 + 3 * 8 + 4 * 8;

  private static final int QUATERNION = 8 + 3 * 8;
  private static final int UNKNOWN = Integer.MIN_VALUE;
  private static final long INTRODUCTION = TimeUnit.SECONDS.toNanos(1);
  private static final int MOST_NAMES = 8;

  private final String tracker;
  private final VrpnStream stream;
  private final PoseSink intake;
  private final long begin = System.nanoTime();
  private int ourSender = UNKNOWN;
  private int poseType = UNKNOWN;

  /** Names of other senders, until ours is known. */
  private final Set<String> names = new TreeSet<>();

  VrpnMessageReader(String tracker, VrpnStream stream, PoseSink intake) {
    this.tracker = tracker;
    this.stream = stream;
    this.intake = intake;
  }

  /**
   * Reads until the tracker is closed.
   *
   * @throws TrackerException if the server has described its senders and ours is not among them
   */
  void read() throws IOException {
    while (!intake.closed()) {
      checkIntroduction();
      if (stream.ready(HEADER)) {
        message();
      }
    }
  }

  private void message() throws IOException {
    int payload = stream.int32(0) - HEADER;
    int sender = stream.int32(12);
    int type = stream.int32(16);
    if (payload < 0 || payload > stream.capacity() - 7) { // The sum below would overflow.
      throw new TrackerException("the VRPN server sent a message of an impossible length");
    }
    int padded = (payload + 7) & ~7;
    stream.skip(HEADER);
    if (stream.require(padded)) {
      message(sender, type, payload, System.nanoTime());
      stream.skip(padded);
    }
  }

  /**
   * Checks that our sender is known a second after the cookies, right after which the server
   * describes its senders.
   */
  private void checkIntroduction() throws TrackerException {
    if (ourSender == UNKNOWN && System.nanoTime() - begin > INTRODUCTION) {
      throw new TrackerException(
          "the VRPN server has no tracker '"
              + tracker
              + "'"
              + (names.isEmpty() ? "" : " (it has " + String.join(", ", names) + ")"));
    }
  }

  private void message(int sender, int type, int payload, long arrival) {
    if (type == SENDER_DESCRIPTION) {
      String name = name(payload);
      if (tracker.equals(name)) {
        ourSender = sender;
      } else if (ourSender == UNKNOWN && names.size() < MOST_NAMES) {
        names.add(name);
      }
    } else if (type == TYPE_DESCRIPTION) {
      if (POSE.equals(name(payload))) {
        poseType = sender; // A type's description has its number in the sender field.
      }
    } else if (type == poseType && sender == ourSender) {
      pose(payload, arrival);
    }
  }

  private void pose(int payload, long arrival) {
    if (payload != POSE_LENGTH) {
      intake.bad();
    } else if (stream.int32(0) == 0) {
      intake.place(stream.float64(8), stream.float64(16), stream.float64(24));
      intake.quaternion(
          arrival,
          stream.float64(QUATERNION),
          stream.float64(QUATERNION + 8),
          stream.float64(QUATERNION + 16),
          stream.float64(QUATERNION + 24));
    }
  }

  /**
   * Returns the name in a description's payload: a length that includes the terminating zero, then
   * the name.
   */
  private String name(int payload) {
    int length = payload < 4 ? 0 : stream.int32(0) - 1;
    if (length < 0 || length > payload - 4) {
      return "";
    }
    return stream.text(4, length);
  }
}
