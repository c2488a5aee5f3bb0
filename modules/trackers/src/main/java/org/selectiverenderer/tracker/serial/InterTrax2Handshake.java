package org.selectiverenderer.tracker.serial;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;

/**
 * The handshake that makes an InterTrax2 send records in any initial state: streaming already, in
 * command mode at either speed, or hung. Steps and timeouts are those of InterSense's driver of
 * 1999.
 */
final class InterTrax2Handshake {
  /** Speed in data mode, bits per second. */
  static final int DATA_BAUD = 38400;

  /** Speed in command mode after power-on, bits per second. */
  static final int COMMAND_BAUD = 1200;

  private static final long REPLY_NANOS = TimeUnit.MILLISECONDS.toNanos(400);
  private static final long PAUSE_MS = 100;
  private static final byte[] RESET = "*reset".getBytes(StandardCharsets.US_ASCII);

  /** Continuous output; 38400 bits per second (acknowledged at the old speed); data mode. */
  private static final byte[][] SET_UP = {{'t', 2}, {'b', 4}, {'d'}};

  private final SerialLine line;
  private final InterTraxRecordDecoder records;
  private final PoseSink intake;
  private final byte[] one = new byte[1];
  private boolean heard;

  InterTrax2Handshake(SerialLine line, InterTraxRecordDecoder records, PoseSink intake) {
    this.line = line;
    this.records = records;
    this.intake = intake;
  }

  /**
   * Runs the handshake, until records arrive or the tracker is being closed.
   *
   * @throws TrackerException if the device does not answer as an InterTrax2
   */
  void run() throws TrackerException {
    if (streams()) {
      return;
    }
    if (!(answersAfterHardwareReset() || answers() || answersAfterReset())) {
      if (!intake.closed()) {
        throw new TrackerException(
            heard
                ? "the device answers, but not as an InterTrax2 does (wrong speed, or another"
                    + " device?)"
                : "no InterTrax2 answers (is it plugged in and powered?)");
      }
      return;
    }
    for (byte[] command : SET_UP) {
      line.write(command);
      if (!reply(command[0])) {
        throw new TrackerException(
            "the InterTrax2 did not accept the command '" + (char) command[0] + "'");
      }
    }
    // The host changes its speed only after the reply to 'd'.
    line.speed(DATA_BAUD);
  }

  /** Returns whether the device is streaming already: two valid records follow each other. */
  private boolean streams() throws TrackerException {
    line.speed(DATA_BAUD);
    byte[] bytes = new byte[256];
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(PAUSE_MS);
    do {
      int count = line.read(bytes);
      heard |= count > 0;
      records.take(bytes, count, System.nanoTime(), intake);
    } while (!records.locked() && System.nanoTime() < end);
    return records.locked();
  }

  private boolean answersAfterHardwareReset() throws TrackerException {
    line.speed(COMMAND_BAUD);
    if (!line.requestToSend(false)) {
      return false;
    }
    pause(150);
    line.requestToSend(true);
    pause(PAUSE_MS);
    return call();
  }

  private boolean answers() throws TrackerException {
    for (int pass = 0; pass < 2; pass++) {
      if (callAt(DATA_BAUD) || callAt(COMMAND_BAUD)) {
        return true;
      }
    }
    return false;
  }

  private boolean answersAfterReset() throws TrackerException {
    return answersAfterReset(DATA_BAUD) || answersAfterReset(COMMAND_BAUD);
  }

  private boolean answersAfterReset(int baud) throws TrackerException {
    line.speed(baud);
    line.write(RESET);
    pause(PAUSE_MS);
    return call();
  }

  private boolean callAt(int baud) throws TrackerException {
    line.speed(baud);
    return call();
  }

  /**
   * Sends {@code c} and returns whether the answer is {@code o}, or {@code !} with another byte.
   */
  private boolean call() throws TrackerException {
    line.write((byte) 'c');
    int answer = next(System.nanoTime() + REPLY_NANOS);
    if (answer == '!') {
      next(System.nanoTime() + REPLY_NANOS);
      return true;
    }
    return answer == 'o';
  }

  private boolean reply(byte expected) throws TrackerException {
    return next(System.nanoTime() + REPLY_NANOS) == expected;
  }

  /** Returns the next byte; -1 after a timeout or if the tracker is being closed. */
  private int next(long until) throws TrackerException {
    while (!intake.closed() && System.nanoTime() < until) {
      if (line.read(one) > 0) {
        heard = true;
        return one[0] & 0xFF;
      }
    }
    return -1;
  }

  private void pause(long milliseconds) {
    long until = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(milliseconds);
    while (!intake.closed() && System.nanoTime() < until) {
      LockSupport.parkNanos(until - System.nanoTime());
    }
  }
}
