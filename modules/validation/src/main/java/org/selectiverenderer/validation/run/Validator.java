package org.selectiverenderer.validation.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationReport;
import org.selectiverenderer.validation.ValidationSettings;

/** Checks scenes with all that they inline, on all processors. */
public final class Validator {
  /**
   * The stack size of worker threads: USEs can nest as deeply as a file is long, and polygons are
   * counted recursively.
   */
  private static final long STACK_BYTES = 256L << 20;

  private final RuleCatalogue rules;
  private final ValidationSettings settings;
  private final Path base;

  /**
   * @param base the folder that names in reports are relative to
   */
  public Validator(RuleCatalogue rules, ValidationSettings settings, Path base) {
    this.rules = rules;
    this.settings = settings;
    this.base = base;
  }

  /**
   * Checks files. Interrupting the calling thread ends it before its next check.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   * @throws IOException if one of them cannot be read; a file that an Inline names may be missing
   */
  public ValidationReport validate(List<SourceFile> files) throws IOException {
    ExecutorService executor =
        Executors.newFixedThreadPool(
            Runtime.getRuntime().availableProcessors(),
            task -> {
              Thread thread = new Thread(null, task, "validator", STACK_BYTES);
              thread.setDaemon(true);
              return thread;
            });
    try {
      return new ValidationRun(rules, settings, base, executor).validate(files);
    } catch (CompletionException e) {
      if (e.getCause() instanceof UncheckedIOException failure) {
        throw failure.getCause();
      } else if (e.getCause() instanceof RuntimeException fault) {
        throw fault;
      } else if (e.getCause() instanceof Error fault) {
        throw fault;
      }
      throw e;
    } finally {
      executor.shutdownNow();
    }
  }
}
