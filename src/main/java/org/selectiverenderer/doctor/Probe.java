package org.selectiverenderer.doctor;

import java.io.IOException;
import java.time.Duration;
import java.util.function.Consumer;

/**
 * A check of one aspect of the machine.
 *
 * @param name name by which a child process is told to run it; lower case
 * @param subject subject of the result if the check fails
 * @param needed whether every user needs what it checks
 * @param place where it runs
 * @param limit the timeout
 */
public record Probe(
    String name, String subject, boolean needed, Place place, Duration limit, Search search) {
  /** Where a probe runs. */
  public enum Place {
    /** In this process: it uses only Java and the file system. */
    HERE,
    /** In a child process: it calls libraries that may crash or hang. */
    APART,
    /** In a child process while no other probe runs, because it measures. */
    ALONE
  }

  /** The code of a probe. */
  @FunctionalInterface
  public interface Search {
    /**
     * @param found receives each result as soon as it is known
     * @throws IOException with a sentence that becomes the result
     */
    void run(Consumer<Diagnosis> found) throws IOException, InterruptedException;
  }
}
