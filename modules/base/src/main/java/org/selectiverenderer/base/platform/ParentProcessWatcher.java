package org.selectiverenderer.base.platform;

import java.util.Optional;

/**
 * Ends a child process when its parent process ends for whatever reason. Without it, a child that
 * shows a window, or one in which a library hangs, would survive a parent that is killed.
 */
public final class ParentProcessWatcher {
  private static final String PROPERTY = "selective-renderer.parent";

  /** The prefix of the child's JVM flag, which the child must not pass to its own children. */
  static final String FLAG = "-D" + PROPERTY + "=";

  /** The interval between two checks of the parent. */
  private static final long PAUSE_MS = 200;

  private ParentProcessWatcher() {}

  /** Returns the JVM flag for a child that should end with this process. */
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
    Optional<ProcessHandle> parent = ProcessHandle.of(pid); // empty if it has ended already
    Thread watch = new Thread(() -> await(parent, end), "parent-watch");
    watch.setDaemon(true);
    watch.start();
  }

  /** Polls the parent, since {@link ProcessHandle#onExit} may take five seconds for a non-child. */
  private static void await(Optional<ProcessHandle> parent, Runnable end) {
    try {
      while (parent.filter(ProcessHandle::isAlive).isPresent()) {
        Thread.sleep(PAUSE_MS);
      }
      end.run();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // only an ending process interrupts it
    }
  }
}
