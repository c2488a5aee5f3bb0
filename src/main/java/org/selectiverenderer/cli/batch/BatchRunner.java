package org.selectiverenderer.cli.batch;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.FailureMessage;
import org.selectiverenderer.command.output.InterruptHandler;

/**
 * Processes many files in parallel, one on each processor. The output of a file is buffered until
 * the files before it are done, and is then printed as a whole; the number of files started ahead
 * is limited to bound memory. A file that cannot be read is reported and the others continue. After
 * Ctrl-C no more files are started.
 */
public final class BatchRunner {
  /** The largest number of unfinished files per processor. */
  private static final int AHEAD = 4;

  private final int processors = Runtime.getRuntime().availableProcessors();
  private final AtomicBoolean stopped = new AtomicBoolean();
  private final Console console;
  private final BatchOutputFormat form;
  private boolean begun;
  private ExitStatus worst = ExitStatus.DONE;

  /** The processing of one file; called on threads of the batch. */
  @FunctionalInterface
  public interface Work {
    /**
     * @param console receives the output of the file
     */
    ExitStatus on(Path file, Console console) throws IOException, InterruptedException;
  }

  private record Result(String out, String err, ExitStatus status) {}

  /**
   * @param console receives the output of all files, in their order
   */
  public BatchRunner(Console console, BatchOutputFormat form) {
    this.console = console;
    this.form = form;
  }

  /**
   * Processes the files.
   *
   * @return {@link ExitStatus#PROBLEMS} if there are problems with any of them
   */
  public ExitStatus run(List<Path> files, Work work) throws IOException {
    AtomicInteger count = new AtomicInteger();
    ExecutorService threads =
        Executors.newFixedThreadPool(
            processors,
            task -> {
              Thread thread = new Thread(task, "batch-" + count.incrementAndGet());
              thread.setDaemon(true);
              return thread;
            });
    try {
      InterruptHandler.stops(() -> stopped.set(true), () -> run(files.iterator(), work, threads));
    } finally {
      threads.shutdownNow();
    }
    return worst;
  }

  private void run(Iterator<Path> files, Work work, ExecutorService threads) {
    Deque<Future<Result>> open = new ArrayDeque<>();
    do {
      while (open.size() < AHEAD * processors && files.hasNext()) {
        Path file = files.next();
        open.add(threads.submit(() -> result(file, work)));
      }
      print(await(open.remove()));
    } while (!open.isEmpty() && !stopped.get());
    print(begun ? form.end() : form.ofNone());
  }

  private static Result await(Future<Result> result) {
    try {
      return result.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw CommandException.environment("interrupted");
    } catch (ExecutionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  private Result result(Path file, Work work) throws InterruptedException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    Console own = new Console(stream(out), stream(err), false);
    ExitStatus status;
    try {
      status = stopped.get() ? ExitStatus.DONE : work.on(file, own);
    } catch (IOException | CommandException e) {
      own.message(named(file, FailureMessage.of(e)));
      status = ExitStatus.PROBLEMS;
    } catch (RuntimeException | StackOverflowError e) { // The other files are processed.
      own.message(named(file, FailureMessage.of(e)));
      status = ExitStatus.FAILURE;
    }
    own.out().flush();
    own.err().flush();
    return new Result(text(out), text(err), status);
  }

  private static String named(Path file, String sentence) {
    return sentence.startsWith(file.toString()) ? sentence : file + ": " + sentence;
  }

  private void print(Result result) {
    console.err().print(result.err());
    if (!result.out().isEmpty()) {
      console.out().print(begun ? form.between() : form.begin());
      begun = true;
      print(form.trimmed(result.out()));
    }
    if (result.status().code() > worst.code()) {
      worst = result.status();
    }
  }

  /** Prints and flushes a text, because a reading process may wait for it. */
  private void print(String text) {
    console.out().print(text);
    console.out().flush();
  }

  private static PrintStream stream(ByteArrayOutputStream bytes) {
    return new PrintStream(bytes, false, StandardCharsets.UTF_8);
  }

  private static String text(ByteArrayOutputStream bytes) {
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
