package org.selectiverenderer.base.platform;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Ends a child process that takes too long for a piece of work, or too much memory, in a thread
 * {@code child-watch}. The memory is known on Linux only.
 */
public final class ChildProcessWatchdog implements AutoCloseable {
  /** The interval between two checks, in which a process can take some 100 MB. */
  private static final long PAUSE_MS = 20;

  private final Process process;
  private final String subject;
  private final Path status;
  private final long start = System.nanoTime();
  private final Thread thread = new Thread(this::watch, "child-watch");
  private volatile Duration time;
  private volatile long memory;
  private volatile @Nullable String verdict;

  /** Guarded by this object, so that a process whose work is done is not ended. */
  private boolean closed;

  /**
   * Begins to watch; the time counts from now.
   *
   * @param subject what the process is, for messages: "the model reader"
   * @param memory the resident memory in bytes that it may take
   */
  public ChildProcessWatchdog(Process process, String subject, Duration time, long memory) {
    this.process = process;
    this.subject = subject;
    this.time = time;
    this.memory = memory;
    status = Path.of("/proc", Long.toString(process.pid()), "status");
    thread.setDaemon(true);
    thread.start();
  }

  /** Replaces the limits; the time still counts from the beginning. */
  public void allow(Duration time, long memory) {
    this.time = time;
    this.memory = memory;
  }

  /** Returns what the process was ended for; empty if it was not. */
  public Optional<String> verdict() {
    return Optional.ofNullable(verdict);
  }

  private void watch() {
    try {
      while (process.isAlive()) {
        String reason = reason();
        if (reason != null) {
          end(reason);
        }
        Thread.sleep(PAUSE_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the work is done
    }
  }

  private synchronized void end(String reason) {
    if (!closed) {
      verdict = reason;
      process.destroyForcibly();
    }
  }

  private @Nullable String reason() {
    Duration most = time;
    if (System.nanoTime() - start > most.toNanos()) {
      return "%s took more than %d s".formatted(subject, most.toSeconds());
    }
    long bytes = memory;
    return resident() > bytes
        ? "%s took more than %d MiB of memory".formatted(subject, bytes >> 20)
        : null;
  }

  /** Returns the process's memory in bytes; 0 if it is not known. */
  private long resident() {
    try {
      for (String line : Files.readString(status, StandardCharsets.ISO_8859_1).split("\n")) {
        if (line.startsWith("VmRSS:")) {
          return Long.parseLong(line.replaceAll("\\D", "")) << 10;
        }
      }
    } catch (IOException e) {
      // another system, or the process has ended
    }
    return 0;
  }

  /** Ends the watch. The process goes on. */
  @Override
  public synchronized void close() {
    closed = true;
    thread.interrupt();
  }
}
