package org.selectiverenderer.base.machine;

import java.util.Optional;

/**
 * The process that started this one, where this one is to end with it, whatever ends that one:
 * where it is killed, nobody else would know of a child that shows a window, or of one in which a
 * library hangs.
 */
public final class ParentProcess {
  private static final String PROPERTY = "selective-renderer.parent";

  /** What the flag of a child begins with, which is not for the child's own children. */
  static final String FLAG = "-D" + PROPERTY + "=";

  /** Between two looks. */
  private static final long PAUSE_MS = 200;

  private ParentProcess() {}

  /** The flag for Java of a child that is to end with this process. */
  public static String flag() {
    return FLAG + ProcessHandle.current().pid();
  }

  /**
   * Waits in a thread {@code parent-watch} for the end of the process that started this one with
   * its {@link #flag()}; does nothing in a process without one.
   *
   * @param end ends this process; called on that thread
   */
  public static void whenItEnds(Runnable end) {
    Long pid = Long.getLong(PROPERTY);
    if (pid == null) {
      return;
    }
    Optional<ProcessHandle> parent = ProcessHandle.of(pid); // None where it has ended already.
    Thread watch = new Thread(() -> await(parent, end), "parent-watch");
    watch.setDaemon(true);
    watch.start();
  }

  /** By looking: Java's own notice of a process that is no child may take five seconds. */
  private static void await(Optional<ProcessHandle> parent, Runnable end) {
    try {
      while (parent.filter(ProcessHandle::isAlive).isPresent()) {
        Thread.sleep(PAUSE_MS);
      }
      end.run();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // Nobody interrupts it but to end it.
    }
  }
}
