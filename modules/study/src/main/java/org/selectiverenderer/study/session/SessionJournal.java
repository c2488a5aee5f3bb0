package org.selectiverenderer.study.session;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.definition.SessionFlag;

/**
 * The journal of a session: an append-only log of events (JSON Lines), each forced to the disk. The
 * thread {@code session-journal} writes, so that a frame need not wait for the disk; {@link #keep}
 * waits until an event is written. {@link SessionLock} ensures that one program writes at a time.
 *
 * <p>Each event has {@code time}, by the wall clock, and {@code mono}, the monotonic clock in
 * seconds, which head logs have too. Durations come from {@code mono}. Its origin holds for one
 * process: from {@code session-began}, and from each {@code resumed} (or the {@code journal-mended}
 * before it), to the process's end. A wall clock that moves against it is flagged. Thread-safe.
 */
public final class SessionJournal implements AutoCloseable {
  private final Path file;
  private final FileChannel channel;
  private final SessionHistory history;
  private final JournalClock clock;
  private final ExecutorService writer =
      Executors.newSingleThreadExecutor(
          work -> {
            Thread thread = new Thread(work, "session-journal");
            thread.setDaemon(true);
            return thread;
          });
  private volatile @Nullable IOException failure;
  private volatile Consumer<JsonNode> listener = event -> {};
  private volatile SignalListener signals = (event, step, fill) -> {};

  /** Hears of moments that are not events of the journal, such as the phases of a trial. */
  @FunctionalInterface
  public interface SignalListener {
    /**
     * Hears of a moment, at once and on the thread on which it happens; must not block.
     *
     * @param event what happens, such as {@code fixation-began} or {@code response}
     * @param step the step in which it happens
     * @param fill replaces names of factors and columns in braces by what the trial has
     */
    void heard(String event, String step, UnaryOperator<String> fill);
  }

  private SessionJournal(
      Path file, FileChannel channel, SessionHistory history, JournalClock clock) {
    this.clock = clock;
    this.file = file;
    this.channel = channel;
    this.history = history;
  }

  /**
   * Begins a journal.
   *
   * @throws IOException if the file cannot be created, or exists already
   */
  static SessionJournal begin(Path file) throws IOException {
    return begin(file, JournalClock.system());
  }

  /** As {@link #begin(Path)}, with clocks of its own. */
  static SessionJournal begin(Path file, JournalClock clock) throws IOException {
    return new SessionJournal(
        file,
        PrivateFiles.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.APPEND),
        SessionHistory.none(),
        clock);
  }

  /**
   * Resumes a journal that ends with a whole line ({@link JournalRecovery}).
   *
   * @throws IOException if the file does not exist or cannot be opened
   */
  static SessionJournal resume(Path file) throws IOException {
    PrivateFiles.requireNoLink(file);
    SessionHistory history = SessionHistory.read(file);
    return new SessionJournal(
        file, FileChannel.open(file, StandardOpenOption.APPEND), history, JournalClock.system());
  }

  /** Returns the history of the events that are on the disk; it grows as events are written. */
  SessionHistory history() {
    return history;
  }

  /** Sets the listener, which receives each event on the thread that logs it; it must not block. */
  public void listen(Consumer<JsonNode> hears) {
    listener = hears;
  }

  /** Sets the listener of signals. */
  public void listenToSignals(SignalListener hears) {
    signals = hears;
  }

  /** Tells the listener of signals of a moment, which is not logged. */
  public void signal(String event, String step, UnaryOperator<String> fill) {
    signals.heard(event, step, fill);
  }

  /**
   * Logs an event without waiting. A write error is thrown by the next {@link #keep}.
   *
   * @param more members of the event: texts, numbers, booleans, lists and maps of these
   */
  public void tell(String event, Map<String, ?> more) {
    submit(event, more);
  }

  /**
   * Raises a quality flag, for {@code status} and {@code collect}, without waiting.
   *
   * @param more further members of the event; {@code step} if the flag concerns a step
   */
  public void flag(SessionFlag flag, Map<String, ?> more) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("flag", flag.spelling());
    members.putAll(more);
    submit("flag", members);
  }

  /**
   * Logs an event and waits until it, and all before it, are on the disk.
   *
   * @throws IOException if this event, or an earlier one, could not be written
   */
  public void keep(String event, Map<String, ?> more) throws IOException {
    Future<?> written = submit(event, more);
    try {
      written.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(file + ": interrupted while an event was being written", e);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    }
    IOException failed = failure;
    if (failed != null) {
      throw named(failed);
    }
  }

  private IOException named(IOException failed) {
    return new IOException(
        "%s: an event could not be written (%s); what was written before is kept, and --resume "
                .formatted(file, failed.getMessage())
            + "continues the session once the disk can be written",
        failed);
  }

  private Future<?> submit(String event, Map<String, ?> more) {
    JournalClock.Reading now = clock.read();
    now.moved().ifPresent(moved -> submit(now, "flag", moved(moved, more)));
    return submit(now, event, more);
  }

  private static Map<String, Object> moved(Duration moved, Map<String, ?> more) {
    Map<String, Object> members = new LinkedHashMap<>();
    Object step = more.get("step");
    if (step != null) {
      members.put("step", step);
    }
    members.put("flag", SessionFlag.CLOCK_MOVED.spelling());
    members.put("seconds", DecimalRounding.to(3, moved.toNanos() * 1e-9));
    return members;
  }

  private Future<?> submit(JournalClock.Reading now, String event, Map<String, ?> more) {
    ObjectNode line = JsonTree.object();
    line.put("time", now.wall().truncatedTo(ChronoUnit.MILLIS).toString());
    line.put("event", event);
    // Map.of has another order in every process: the step comes first.
    Object step = more.get("step");
    if (step != null) {
      line.put("step", String.valueOf(step));
    }
    more.forEach((key, value) -> line.set(key, JsonTree.of(value)));
    line.put("mono", DecimalRounding.to(6, now.nanos() * 1e-9));
    listener.accept(line);
    return writer.submit(() -> write(line));
  }

  private void write(ObjectNode line) {
    try {
      long before = channel.size();
      try {
        DiskSync.write(channel, (line + "\n").getBytes(StandardCharsets.UTF_8));
        channel.force(false);
      } catch (IOException e) {
        takeBack(before, e);
        throw e;
      }
      history.add(line);
    } catch (IOException e) {
      failure = e;
    }
  }

  /** Removes a partly written event, else the next one would be appended to its line. */
  private void takeBack(long size, IOException failed) {
    try {
      channel.truncate(size);
    } catch (IOException e) {
      failed.addSuppressed(e); // --resume recovers the line.
    }
  }

  /**
   * Writes the remaining events and closes the file.
   *
   * @throws IOException if an event could not be written
   */
  @Override
  public void close() throws IOException {
    writer.shutdown();
    try {
      while (!writer.awaitTermination(1, TimeUnit.MINUTES)) {
        // The loop waits for a slow disk, so that no event is lost.
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    channel.close();
    IOException failed = failure;
    if (failed != null) {
      throw named(failed);
    }
  }
}
