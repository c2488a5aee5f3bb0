package org.selectiverenderer.study.session;

/** Journals of sessions. */
public final class JournalFuzzTarget {
  private JournalFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    JournalContent.of(input);
  }
}
