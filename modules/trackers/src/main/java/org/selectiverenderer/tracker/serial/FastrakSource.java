package org.selectiverenderer.tracker.serial;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;
import org.selectiverenderer.tracker.text.FastrakRecordParser;
import org.selectiverenderer.tracker.text.LineSplitter;

/**
 * Reads a Polhemus Fastrak, or an InterSense IS-300, IS-600 or IS-900 in Fastrak mode, on a serial
 * port: ASCII records of station 1 in continuous mode. Not tested with the device.
 */
public final class FastrakSource implements PoseSource {
  private static final long FIRST_RECORD = TimeUnit.SECONDS.toNanos(1);

  /** Maximum time in which the rest of an old record arrives after the stop command. */
  private static final long QUIET = TimeUnit.MILLISECONDS.toNanos(300);

  private final String port;
  private final int baud;
  private SerialLine line;

  /**
   * @param port the name of the serial port
   * @param baud speed of the device in bits per second
   */
  public FastrakSource(String port, int baud) {
    this.port = port;
    this.baud = baud;
  }

  @Override
  public void open() throws TrackerException {
    line = SerialLine.open(port, baud);
  }

  @Override
  public void read(PoseSink intake) throws TrackerException {
    byte[] bytes = new byte[1024];
    setUp(bytes, intake);
    Counting counting = new Counting();
    LineSplitter lines = new LineSplitter(counting, true);
    long begin = System.nanoTime();
    boolean connected = false;
    long heard = 0;
    while (!intake.closed()) {
      int count = line.read(bytes);
      long now = System.nanoTime();
      heard += count;
      lines.take(bytes, count, now, intake);
      if (!connected && counting.records > 0) {
        connected = true;
        intake.connected();
      }
      if (connected) {
        intake.tick();
      } else if (now - begin > FIRST_RECORD) {
        throw new TrackerException(
            heard == 0
                ? "no Fastrak answers (is it powered, and set to " + baud + " bits per second?)"
                : "the device answers, but not as a Fastrak does at "
                    + baud
                    + " bits per second (another speed? fastrak:PORT@SPEED)");
      }
    }
  }

  /**
   * Stops continuous output, selects ASCII, centimetres, and for station 1 position, angles and
   * line end, then starts continuous output.
   */
  private void setUp(byte[] bytes, PoseSink intake) throws TrackerException {
    send("c");
    long begin = System.nanoTime();
    while (!intake.closed() && line.read(bytes) > 0 && System.nanoTime() - begin < QUIET) {
      // Discards what was sent before the command.
    }
    send("F");
    send("u");
    send("O1,2,4,1\r\n");
    send("C");
  }

  private void send(String command) throws TrackerException {
    line.write(command.getBytes(StandardCharsets.US_ASCII));
  }

  @Override
  public boolean placed() {
    return true;
  }

  @Override
  public void close() {
    if (line != null) {
      line.close();
      line = null;
    }
  }

  /** Counts good records. */
  private static final class Counting implements LineSplitter.Records {
    private final FastrakRecordParser record = new FastrakRecordParser();
    private long records;

    @Override
    public boolean read(byte[] line, int length, long arrival, PoseSink intake) {
      boolean good = record.read(line, length, arrival, intake);
      records += good ? 1 : 0;
      return good;
    }
  }
}
