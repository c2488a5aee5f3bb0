package org.selectiverenderer.doctor;

import java.io.IOException;
import java.time.Duration;
import java.util.function.Consumer;

/**
 * Looks at one thing of a machine.
 *
 * @param name by which a child process is told to make it; small letters
 * @param subject of the line that is written if it fails
 * @param needed whether nobody can do without what it looks at
 * @param place where it is made
 * @param limit after which it is given up
 */
public record Probe(
    String name, String subject, boolean needed, Place place, Duration limit, Search search) {
  /** Where a probe is made. */
  public enum Place {
    /** In this process: it calls nothing but Java and the file system. */
    HERE,
    /** In a process of its own: it calls libraries that may crash or hang. */
    APART,
    /** The same, while nothing else is done, as it measures. */
    ALONE
  }

  /** What a probe does. */
  @FunctionalInterface
  public interface Search {
    /**
     * @param found takes each line as soon as it is known
     * @throws IOException with a sentence that becomes the line
     */
    void run(Consumer<Diagnosis> found) throws IOException, InterruptedException;
  }
}
