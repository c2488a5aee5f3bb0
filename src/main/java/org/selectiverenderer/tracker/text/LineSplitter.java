package org.selectiverenderer.tracker.text;

import org.selectiverenderer.tracker.live.PoseSink;

/** Cuts bytes into lines that end with LF or CR LF. Empty lines are passed over. */
public final class LineSplitter {
  /** A longer line is no record: what was read of it is thrown away up to its end. */
  public static final int LONGEST = 256;

  /** What is done with a line. */
  public interface Records {
    /**
     * Reads a line.
     *
     * @param line bytes; valid during the call only
     * @param length of the line, without its end
     * @return whether it was a record that could be read
     */
    boolean read(byte[] line, int length, long arrival, PoseSink intake);
  }

  private final Records records;
  private final byte[] line = new byte[LONGEST];
  private int length;
  private boolean tooLong;
  private boolean whole;

  /**
   * @param whole whether the first bytes begin a line; else they are passed over up to its end
   */
  public LineSplitter(Records records, boolean whole) {
    this.records = records;
    this.whole = whole;
  }

  /** Takes bytes as they arrived, and tells the intake of each line that is complete. */
  public void take(byte[] bytes, int count, long arrival, PoseSink intake) {
    for (int i = 0; i < count; i++) {
      if (bytes[i] == '\n') {
        end(arrival, intake);
      } else if (length < LONGEST) {
        line[length++] = bytes[i];
      } else {
        tooLong = true;
        length = 0;
        intake.bad();
      }
    }
  }

  private void end(long arrival, PoseSink intake) {
    if (length > 0 && line[length - 1] == '\r') {
      length--;
    }
    if (whole && !tooLong && length > 0 && !records.read(line, length, arrival, intake)) {
      intake.bad();
    }
    length = 0;
    tooLong = false;
    whole = true;
  }
}
