package org.selectiverenderer.tracker.serial;

import java.util.Arrays;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.RecordingPoseSink;
import org.selectiverenderer.tracker.text.AngleLineParser;
import org.selectiverenderer.tracker.text.FastrakRecordParser;
import org.selectiverenderer.tracker.text.LineSplitter;

/** What an InterTrax2, a Fastrak and a sender of lines send, in pieces of any length. */
public final class SerialTrackerFuzzTarget {
  private SerialTrackerFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    PoseSink sink = new RecordingPoseSink();
    InterTraxRecordDecoder interTrax = new InterTraxRecordDecoder();
    LineSplitter fastrak = new LineSplitter(new FastrakRecordParser(), false);
    LineSplitter angles = new LineSplitter(new AngleLineParser(), true);
    for (int from = 0, length = 1; from < input.length; from += length, length = 3 * length + 1) {
      byte[] piece = Arrays.copyOfRange(input, from, Math.min(input.length, from + length));
      interTrax.take(piece, piece.length, 0, sink);
      fastrak.take(piece, piece.length, 0, sink);
      angles.take(piece, piece.length, 0, sink);
    }
  }
}
