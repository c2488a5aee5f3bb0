package org.selectiverenderer.tracker.net;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.RecordingPoseSink;

/** What a VRPN server sends. */
public final class VrpnFuzzTarget {
  private VrpnFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    PoseSink sink = new RecordingPoseSink();
    InputStream from = new ByteArrayInputStream(input);
    try {
      new VrpnMessageReader("Tracker0", new VrpnStream(from, sink), sink).read();
    } catch (IOException e) {
      // The connection ended, or the server speaks another protocol.
    }
  }
}
