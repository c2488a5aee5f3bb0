package org.selectiverenderer.tracker.report;

import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Hands every record from the tracker's thread to the one that writes. Of fixed size: when the
 * writer cannot keep up, new records are left out and counted, and the tracker never waits.
 */
final class SampleQueue {
  private static final int SIZE = 1 << 14;

  private final PoseSample[] ring = new PoseSample[SIZE];
  private final AtomicLong written = new AtomicLong();
  private final AtomicLong read = new AtomicLong();
  private final AtomicLong lost = new AtomicLong();

  SampleQueue() {
    for (int i = 0; i < SIZE; i++) {
      ring[i] = new PoseSample();
    }
  }

  /** Adds a copy; called by one thread. */
  void add(PoseSample sample) {
    long at = written.get();
    if (at - read.get() == SIZE) {
      lost.incrementAndGet();
      return;
    }
    ring[(int) (at % SIZE)].set(sample);
    written.set(at + 1);
  }

  /** Takes the oldest; false when there is none; called by one thread. */
  boolean take(PoseSample into) {
    long at = read.get();
    if (at == written.get()) {
      return false;
    }
    into.set(ring[(int) (at % SIZE)]);
    read.set(at + 1);
    return true;
  }

  /** How many were left out. */
  long lost() {
    return lost.get();
  }
}
