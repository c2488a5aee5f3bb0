package org.selectiverenderer.tracker.emulator;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Emulates the device's side of the InterTrax2 protocol: answers commands and, in continuous mode,
 * sends records. Two threads, one for each direction, end when the connection is closed. As a test
 * it is only as good as the source of the protocol: see {@code tracker.serial.InterTrax2Source}.
 *
 * <p>A pseudo-terminal has no speed: the emulator understands commands at any.
 */
public final class InterTrax2Emulator implements AutoCloseable {
  /** Maximum rate in records per second: records of 8 bytes at 38400 bits per second. */
  public static final double FASTEST = 480;

  /**
   * The settings of the emulator.
   *
   * @param rateHz records per second, above 0 and at most {@link #FASTEST}
   * @param motion the motion of the head
   */
  public record Settings(double rateHz, HeadMotion motion) {
    /**
     * @throws IllegalArgumentException if the rate is out of range
     */
    public Settings {
      if (!(rateHz > 0 && rateHz <= FASTEST)) {
        throw new IllegalArgumentException("the rate must be above 0 and at most 480 records/s");
      }
    }
  }

  private static final String RESET = "*reset";

  private final InputStream fromHost;
  private final OutputStream toHost;
  private final Settings settings;
  private final long begin = System.nanoTime();
  private final Thread listening;
  private final Thread sending;
  private volatile boolean streaming;
  private volatile boolean closed;
  private boolean continuous;

  private InterTrax2Emulator(InputStream fromHost, OutputStream toHost, Settings settings) {
    this.fromHost = fromHost;
    this.toHost = toHost;
    this.settings = settings;
    listening = thread("emulator-commands", this::listen);
    sending = thread("emulator-records", this::send);
  }

  /** Starts an emulator, which waits for commands. */
  public static InterTrax2Emulator start(
      InputStream fromHost, OutputStream toHost, Settings settings) {
    InterTrax2Emulator emulator = new InterTrax2Emulator(fromHost, toHost, settings);
    emulator.listening.start();
    emulator.sending.start();
    return emulator;
  }

  private static Thread thread(String name, Runnable work) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    return thread;
  }

  /** Returns whether the emulator sends records continuously. */
  public boolean streaming() {
    return streaming;
  }

  /** Ends the threads; the caller closes the streams, before or after. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(sending);
  }

  private void listen() {
    try {
      int command = fromHost.read();
      while (command >= 0 && !closed) {
        obey(command);
        command = fromHost.read();
      }
    } catch (IOException e) {
      closed = true; // The cable was pulled.
    }
    close();
  }

  private void obey(int command) throws IOException {
    switch (command) {
      case 'c' -> {
        streaming = false;
        answer('o');
      }
      case 't' -> {
        continuous = fromHost.read() == 2;
        answer('t');
      }
      case 'b' -> {
        fromHost.read(); // The speed's code.
        answer('b');
      }
      case 'd' -> {
        answer('d');
        streaming = continuous;
        LockSupport.unpark(sending);
      }
      case '3' -> poll();
      case '*' -> reset();
      default -> {
        // The device ignores unknown commands.
      }
    }
  }

  private void reset() throws IOException {
    for (int i = 1; i < RESET.length(); i++) {
      if (fromHost.read() != RESET.charAt(i)) {
        return;
      }
    }
    streaming = false;
    continuous = false;
  }

  private void poll() throws IOException {
    PoseSample pose = new PoseSample();
    settings.motion().at(seconds(), pose);
    byte[] record = new byte[InterTraxRecordEncoder.POLLED_LENGTH];
    InterTraxRecordEncoder.polled(pose, record, 0);
    write(record);
  }

  private void answer(char reply) throws IOException {
    write(new byte[] {(byte) reply});
  }

  private void send() {
    PoseSample pose = new PoseSample();
    byte[] record = new byte[InterTraxRecordEncoder.LENGTH];
    long period = (long) (TimeUnit.SECONDS.toNanos(1) / settings.rateHz());
    long due = System.nanoTime();
    try {
      while (!closed) {
        if (!streaming) {
          LockSupport.park(this);
          due = System.nanoTime();
          continue;
        }
        settings.motion().at(seconds(), pose);
        InterTraxRecordEncoder.continuous(pose, record);
        write(record);
        due = next(due, period, System.nanoTime());
        while (!closed && System.nanoTime() < due) {
          LockSupport.parkNanos(this, due - System.nanoTime());
        }
      }
    } catch (IOException e) {
      closed = true; // The cable was pulled.
    }
  }

  /** Returns when the next record is due: after a blocked write, missed records are skipped. */
  static long next(long due, long period, long now) {
    return Math.max(due + period, now);
  }

  private double seconds() {
    return (System.nanoTime() - begin) * 1e-9;
  }

  private void write(byte[] bytes) throws IOException {
    synchronized (toHost) {
      toHost.write(bytes);
      toHost.flush();
    }
  }

  /** Encodes the records of an InterTrax. */
  static final class InterTraxRecordEncoder {
    /** Length of a continuous record: header, three numbers, checksum. */
    static final int LENGTH = 8;

    /** Length of a polled record: three numbers. */
    static final int POLLED_LENGTH = 6;

    private InterTraxRecordEncoder() {}

    /** Writes a continuous record. */
    static void continuous(PoseSample pose, byte[] into) {
      into[0] = (byte) 0x80;
      polled(pose, into, 1);
      int sum = 0;
      for (int i = 0; i < LENGTH - 1; i++) {
        sum += into[i];
      }
      into[LENGTH - 1] = (byte) -sum;
    }

    /** Writes the numbers only, from an index on. */
    static void polled(PoseSample pose, byte[] into, int at) {
      number(pose.yaw(), into, at);
      number(pose.pitch(), into, at + 2);
      number(pose.roll(), into, at + 4);
    }

    private static void number(double degrees, byte[] into, int at) {
      int value = (int) Math.rint(degrees * 32768 / 180);
      into[at] = (byte) value;
      into[at + 1] = (byte) (value >> 8);
    }
  }
}
