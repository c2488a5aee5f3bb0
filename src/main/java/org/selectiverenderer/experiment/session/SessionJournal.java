package org.selectiverenderer.experiment.session;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.Disk;
import org.selectiverenderer.base.json.JsonTree;

/**
 * The events of a session, one JSON object a line, each forced to the disk. A thread of its own,
 * {@code session-journal}, writes, so that a frame need not wait for a disk; who must know that an
 * event is kept waits for it. The file is locked: a session has one journal at a time. May be told
 * things by any thread.
 */
public final class SessionJournal implements AutoCloseable {
  private final Path file;
  private final FileChannel channel;
  private final FileLock lock;
  private final ExecutorService writer =
      Executors.newSingleThreadExecutor(
          work -> {
            Thread thread = new Thread(work, "session-journal");
            thread.setDaemon(true);
            return thread;
          });
  private volatile @Nullable IOException failure;
  private volatile Consumer<JsonNode> listener = event -> {};

  private SessionJournal(Path file, FileChannel channel, FileLock lock) {
    this.file = file;
    this.channel = channel;
    this.lock = lock;
  }

  /**
   * Opens a journal and goes to its end. A last line that a crash cut off is ended there, so that
   * it stays what it is: no event.
   *
   * @param fresh whether the file must not be there yet; else it must
   * @throws IOException if it cannot be opened, or another program has it
   */
  static SessionJournal open(Path file, boolean fresh) throws IOException {
    FileChannel channel =
        fresh
            ? FileChannel.open(
                file,
                StandardOpenOption.CREATE_NEW,
                StandardOpenOption.READ,
                StandardOpenOption.WRITE)
            : FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE);
    try {
      FileLock lock = channel.tryLock();
      if (lock == null) {
        throw new IOException(
            file + ": another program is running this session; wait until it has ended");
      }
      SessionJournal journal = new SessionJournal(file, channel, lock);
      journal.toTheEnd();
      return journal;
    } catch (OverlappingFileLockException e) {
      channel.close();
      throw new IOException(file + ": this session is already running", e);
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  private void toTheEnd() throws IOException {
    long size = channel.size();
    channel.position(size);
    ByteBuffer last = ByteBuffer.allocate(1);
    if (size > 0 && channel.read(last, size - 1) == 1 && last.get(0) != '\n') {
      channel.write(ByteBuffer.wrap(new byte[] {'\n'}));
    }
  }

  /** Has somebody hear each event as it is told, on the thread that tells it; must not wait. */
  public void listen(Consumer<JsonNode> hears) {
    listener = hears;
  }

  /**
   * Tells an event; does not wait. A disk that fails is told by the next {@link #keep}.
   *
   * @param more members of the event: texts, numbers, truth values, lists and maps of such
   */
  public void tell(String event, Map<String, ?> more) {
    submit(event, more);
  }

  /**
   * Tells an event and waits until it, and all before it, is on the disk.
   *
   * @throws IOException if it, or one before it, could not be written
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
      throw new IOException(
          file + ": an event could not be written: " + failed.getMessage(), failed);
    }
  }

  private Future<?> submit(String event, Map<String, ?> more) {
    ObjectNode line = JsonTree.object();
    line.put("time", OffsetDateTime.now().truncatedTo(ChronoUnit.MILLIS).toString());
    line.put("event", event);
    // Map.of has another order in every process: what an event is of comes first.
    Object step = more.get("step");
    if (step != null) {
      line.put("step", String.valueOf(step));
    }
    more.forEach((key, value) -> line.set(key, JsonTree.of(value)));
    listener.accept(line);
    byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
    return writer.submit(() -> write(bytes));
  }

  private void write(byte[] bytes) {
    try {
      Disk.write(channel, bytes);
      channel.force(false);
    } catch (IOException e) {
      failure = e;
    }
  }

  /**
   * Writes what is left and lets go of the file.
   *
   * @throws IOException if something could not be written
   */
  @Override
  public void close() throws IOException {
    writer.shutdown();
    try {
      while (!writer.awaitTermination(1, TimeUnit.MINUTES)) {
        // A slow disk is waited for: an event that was told is kept.
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    lock.release();
    channel.close();
    IOException failed = failure;
    if (failed != null) {
      throw failed;
    }
  }
}
