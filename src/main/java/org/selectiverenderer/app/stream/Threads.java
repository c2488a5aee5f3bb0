package org.selectiverenderer.app.stream;

/** Waits for threads that end by themselves. */
final class Threads {
  private Threads() {}

  /** Waits for the end of a thread; who interrupts the caller is heard afterwards. */
  static void join(Thread thread) {
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true; // What was recorded is written first.
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
