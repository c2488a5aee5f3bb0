package org.selectiverenderer.experiment.session;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.WholeFile;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;

/**
 * That a session, or a participant's pilot, is run by one program. The operating system's lock on
 * {@value #LOCK} decides, and goes with the process, however that ends: a file left by a crash
 * locks nothing. {@value #HOLDER} beside it says who has the lock, for messages.
 *
 * <p>These are two files, and nothing but this class ever opens the first: on POSIX systems a
 * process that closes any descriptor of a file loses its locks on that file (fcntl), so a file that
 * is read by its owner cannot be the lock; and on Windows a locked file cannot be read by others.
 */
public final class SessionLock implements AutoCloseable {
  static final String LOCK = "session.lock";
  static final String HOLDER = "running.json";

  private static final String UNKNOWN = "another program";

  private final FileChannel channel;
  private final FileLock lock;
  private final Path holder;

  private SessionLock(FileChannel channel, FileLock lock, Path holder) {
    this.channel = channel;
    this.lock = lock;
    this.holder = holder;
  }

  /** How a file is locked; a test has it fail. */
  interface Locking {
    /** The operating system's. */
    Locking REAL = FileChannel::tryLock;

    /**
     * Locks a whole file without waiting.
     *
     * @return null where another process has it
     */
    FileLock lock(FileChannel channel) throws IOException;
  }

  /**
   * Takes the lock of a folder, which must be there.
   *
   * @param software name and version of the program, for others' messages
   * @throws IOException if another program has it, with a line that names it; or if the disk cannot
   *     be written or knows no locks
   */
  public static SessionLock take(Path folder, String software) throws IOException {
    return take(folder, software, Locking.REAL);
  }

  /** The same by another way of locking. */
  static SessionLock take(Path folder, String software, Locking locking) throws IOException {
    Path holder = folder.resolve(HOLDER);
    ObjectNode self = self(software);
    if (read(holder).filter(known -> sameProcess(known, self)).isPresent()) {
      throw held(folder); // The lock's file is not touched: to close it again would free it.
    }
    FileChannel channel =
        FileChannel.open(folder.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    try {
      FileLock lock = lock(folder, channel, locking);
      WholeFile.replace(holder, JsonText.of(self).getBytes(StandardCharsets.UTF_8));
      return new SessionLock(channel, lock, holder);
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  private static FileLock lock(Path folder, FileChannel channel, Locking locking)
      throws IOException {
    FileLock lock;
    try {
      lock = locking.lock(channel);
    } catch (OverlappingFileLockException e) {
      throw held(folder);
    } catch (IOException e) {
      throw noLocks(folder.resolve(LOCK), e);
    }
    if (lock == null) {
      throw held(folder);
    }
    return lock;
  }

  /** What is said of a disk that cannot lock a file, such as a network drive. */
  static IOException noLocks(Path file, IOException e) {
    return new IOException(
        "%s cannot be locked (%s), so two programs could write at the same time; "
                .formatted(file, e.getMessage())
            + "move the study to a disk that knows locks, such as one of this computer",
        e);
  }

  private static IOException held(Path folder) {
    return new IOException(
        "%s is being run by %s; wait until that has ended, or end it"
            .formatted(
                folder, read(folder.resolve(HOLDER)).map(SessionLock::told).orElse(UNKNOWN)));
  }

  private static String told(JsonNode holder) {
    return "%s (process %s on %s, since %s)"
        .formatted(
            holder.path("program").asText(UNKNOWN),
            holder.path("pid").asText("?"),
            holder.path("host").asText("?"),
            holder.path("since").asText("?"));
  }

  private static ObjectNode self(String software) {
    ProcessHandle process = ProcessHandle.current();
    return JsonTree.object()
        .put("program", software)
        .put("pid", process.pid())
        .put("started", process.info().startInstant().map(Instant::toString).orElse(""))
        .put("host", host())
        .put("since", OffsetDateTime.now().truncatedTo(ChronoUnit.SECONDS).toString());
  }

  /** Containers give each program the same number: when it started tells them apart. */
  private static boolean sameProcess(JsonNode one, JsonNode other) {
    return Stream.of("pid", "started", "host")
        .allMatch(key -> one.path(key).asText().equals(other.path(key).asText()));
  }

  private static String host() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "a computer without a name";
    }
  }

  /** Who is said to have it; empty where nobody is, or nobody can tell. */
  private static Optional<JsonNode> read(Path holder) {
    try {
      return Files.isRegularFile(holder) ? Optional.of(JsonTree.read(holder)) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty(); // Left half written by a crash: the lock decides, not this file.
    }
  }

  /** Lets go of it; once more does nothing, as by then it may be another program's. */
  @Override
  public void close() throws IOException {
    if (!channel.isOpen()) {
      return;
    }
    try (channel) {
      Files.deleteIfExists(holder);
      if (lock.isValid()) {
        lock.release();
      }
    }
  }
}
