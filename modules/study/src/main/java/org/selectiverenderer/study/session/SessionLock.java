package org.selectiverenderer.study.session;

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
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;

/**
 * The lock by which one program at a time runs a session, or a participant's threshold pilot. It is
 * the operating system's lock on the file {@value #LOCK}, which is released when the process ends,
 * however that ends: a file left by a crash locks nothing. {@value #HOLDER} beside it names the
 * holder, for messages.
 *
 * <p>The lock and the holder are two files, and only this class opens the first: on POSIX systems a
 * process that closes any descriptor of a file loses its locks on that file (fcntl), so a file that
 * its owner reads cannot be the lock; and on Windows others cannot read a locked file.
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

  /** Locks a file; tests replace it by one that fails. */
  interface Locking {
    /** The lock of the operating system. */
    Locking REAL = FileChannel::tryLock;

    /**
     * Locks a whole file without waiting.
     *
     * @return null if another process holds the lock
     */
    FileLock lock(FileChannel channel) throws IOException;
  }

  /**
   * Takes the lock of an existing folder.
   *
   * @param software name and version of the program, for others' messages
   * @throws IOException if another program holds the lock, with a message that names it; or if the
   *     disk cannot be written or does not support locks
   */
  public static SessionLock take(Path folder, String software) throws IOException {
    return take(folder, software, Locking.REAL);
  }

  /** Takes the lock by another implementation of locking. */
  static SessionLock take(Path folder, String software, Locking locking) throws IOException {
    Path holder = folder.resolve(HOLDER);
    ObjectNode self = self(software);
    if (read(holder).filter(known -> sameProcess(known, self)).isPresent()) {
      throw taken(folder); // Opening and closing the lock's file would release the lock.
    }
    PrivateFiles.requireNoLink(folder.resolve(LOCK));
    InputFileReader.requireRegular(folder.resolve(LOCK)); // To open a pipe would wait for ever.
    InputFileReader.requireRegular(holder);
    FileChannel channel =
        PrivateFiles.open(
            folder.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    try {
      FileLock lock = lock(folder, channel, locking);
      AtomicFileWriter.replace(
          holder,
          JsonWriter.of(self).getBytes(StandardCharsets.UTF_8),
          FileOperations.PRIVATE_UNLINKED);
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
      throw taken(folder);
    } catch (IOException e) {
      throw noLocks(folder.resolve(LOCK), e);
    }
    if (lock == null) {
      throw taken(folder);
    }
    return lock;
  }

  /** Returns the exception for a disk that does not support locks, such as some network drives. */
  static IOException noLocks(Path file, IOException e) {
    return new IOException(
        "%s cannot be locked (%s), so two programs could write at the same time; "
                .formatted(file, e.getMessage())
            + "move the study to a disk that supports file locks, such as a local disk",
        e);
  }

  private static IOException taken(Path folder) {
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

  /**
   * Returns whether a process of this computer holds the lock of a folder, as far as its holder's
   * file tells: it does not touch the lock, and a holder that has crashed does not count. A process
   * on another computer, as on a shared disk, counts as a holder.
   */
  public static boolean held(Path folder) {
    return read(folder.resolve(HOLDER)).filter(SessionLock::alive).isPresent();
  }

  private static boolean alive(JsonNode holder) {
    if (!holder.path("host").asText().equals(host())) {
      return true;
    }
    return ProcessHandle.of(holder.path("pid").asLong())
        .filter(ProcessHandle::isAlive)
        .filter(
            process ->
                process
                    .info()
                    .startInstant()
                    .map(Instant::toString)
                    .orElse("")
                    .equals(holder.path("started").asText()))
        .isPresent();
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

  /** Compares the start times, too: in containers, processes often have the same id. */
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

  /** Reads the holder; empty if the file does not exist or cannot be read. */
  private static Optional<JsonNode> read(Path holder) {
    try {
      return Files.isRegularFile(holder) ? Optional.of(JsonTree.read(holder)) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty(); // A crash may truncate the file; the lock decides.
    }
  }

  /** Releases the lock; a second call does nothing, as another program may hold it by then. */
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
