package org.selectiverenderer.tracker.report;

import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.tracker.PoseSample;

/**
 * A lock-free ring buffer that passes records from the tracker's thread to the writing thread.
 * While it is full, new records are dropped and counted; the tracker never waits.
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

  /** Adds a copy of a record; called by one thread. */
  void add(PoseSample sample) {
    long at = written.get();
    if (at - read.get() == SIZE) {
      lost.incrementAndGet();
      return;
    }
    ring[(int) (at % SIZE)].set(sample);
    written.set(at + 1);
  }

  /** Takes the oldest record; returns false if there is none; called by one thread. */
  boolean take(PoseSample into) {
    long at = read.get();
    if (at == written.get()) {
      return false;
    }
    into.set(ring[(int) (at % SIZE)]);
    read.set(at + 1);
    return true;
  }

  /** Returns the number of dropped records. */
  long lost() {
    return lost.get();
  }
}
