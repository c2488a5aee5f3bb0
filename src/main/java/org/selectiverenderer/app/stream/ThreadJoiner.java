package org.selectiverenderer.app.stream;

/** Joins threads without being interrupted. */
final class ThreadJoiner {
  private ThreadJoiner() {}

  /** Waits for the end of a thread; an interrupt of the caller is restored afterwards. */
  static void join(Thread thread) {
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true; // The recorded samples are written first.
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
