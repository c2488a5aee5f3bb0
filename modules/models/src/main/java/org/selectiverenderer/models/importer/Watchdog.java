package org.selectiverenderer.models.importer;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Ends a child process that takes too long for a model, or too much memory, in a thread {@code
 * model-import-watch}. The memory is known on Linux only.
 */
final class Watchdog implements AutoCloseable {
  /** The interval between two checks, in which a process can take some 100 MB. */
  private static final long PAUSE_MS = 20;

  private final Process process;
  private final ImportLimits limits;
  private final Path status;
  private final long start = System.nanoTime();
  private final Thread thread = new Thread(this::watch, "model-import-watch");
  private volatile long served;
  private volatile @Nullable String verdict;

  Watchdog(Process process, ImportLimits limits) {
    this.process = process;
    this.limits = limits;
    status = Path.of("/proc", Long.toString(process.pid()), "status");
    thread.setDaemon(true);
    thread.start();
  }

  /** Raises the limits for files of so many bytes. */
  void serves(long bytes) {
    served = bytes;
  }

  /** Returns what the process was ended for; empty if it was not. */
  Optional<String> verdict() {
    return Optional.ofNullable(verdict);
  }

  private void watch() {
    try {
      while (process.isAlive()) {
        String reason = reason();
        if (reason != null) {
          verdict = reason;
          process.destroyForcibly();
        }
        Thread.sleep(PAUSE_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the model has been read
    }
  }

  private @Nullable String reason() {
    Duration time = limits.time(served);
    if (System.nanoTime() - start > time.toNanos()) {
      return "the model reader took more than %d s".formatted(time.toSeconds());
    }
    long memory = limits.memory(served);
    return resident() > memory
        ? "the model reader took more than %d MiB of memory".formatted(memory >> 20)
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

  @Override
  public void close() {
    thread.interrupt();
  }
}
