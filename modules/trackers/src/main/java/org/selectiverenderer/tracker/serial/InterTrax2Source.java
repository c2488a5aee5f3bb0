package org.selectiverenderer.tracker.serial;

import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;

/**
 * Reads an InterSense InterTrax2 on a serial port, in continuous mode. Azimuth, elevation and twist
 * are yaw, pitch and roll.
 *
 * <p>The protocol is that of InterSense's own InterTrax driver of 1999, as published with VR
 * Juggler; that the InterTrax2 uses the same protocol on its serial port is inferred. Not tested
 * with the device.
 */
public final class InterTrax2Source implements PoseSource {
  private final String port;
  private SerialLine line;

  /**
   * @param port the name of the serial port
   */
  public InterTrax2Source(String port) {
    this.port = port;
  }

  @Override
  public void open() throws TrackerException {
    line = SerialLine.open(port, InterTrax2Handshake.DATA_BAUD);
  }

  @Override
  public void read(PoseSink intake) throws TrackerException {
    InterTraxRecordDecoder records = new InterTraxRecordDecoder();
    new InterTrax2Handshake(line, records, intake).run();
    if (intake.closed()) {
      return;
    }
    intake.connected();
    byte[] bytes = new byte[1024];
    while (!intake.closed()) {
      int count = line.read(bytes);
      records.take(bytes, count, System.nanoTime(), intake);
      intake.tick();
    }
  }

  @Override
  public void close() {
    if (line != null) {
      line.close();
      line = null;
    }
  }
}
