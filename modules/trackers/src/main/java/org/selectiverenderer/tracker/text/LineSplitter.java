package org.selectiverenderer.tracker.text;

import org.selectiverenderer.tracker.pipeline.PoseSink;

/** Splits bytes into lines that end with LF or CR LF. Empty lines are skipped. */
public final class LineSplitter {
  /** Maximum length of a line; a longer one is not a record and is discarded. */
  public static final int LONGEST = 256;

  /** Parses a line. */
  public interface Records {
    /**
     * Reads a line.
     *
     * @param line bytes of the line; valid during the call only
     * @param length of the line, without its end
     * @return whether the line was a valid record
     */
    boolean read(byte[] line, int length, long arrival, PoseSink intake);
  }

  private final Records records;
  private final byte[] line = new byte[LONGEST];
  private int length;
  private boolean tooLong;
  private boolean whole;

  /**
   * @param whole whether the first bytes begin a line; if not, they are skipped up to the line end
   */
  public LineSplitter(Records records, boolean whole) {
    this.records = records;
    this.whole = whole;
  }

  /** Splits bytes as they arrived, and passes the record of each complete line to the sink. */
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
