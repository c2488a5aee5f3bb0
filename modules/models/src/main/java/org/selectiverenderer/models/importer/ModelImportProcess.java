package org.selectiverenderer.models.importer;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.base.platform.ChildProcessWatchdog;

/**
 * Reads models of other programs in a child process, one after another. The process is started when
 * it is first needed, and again after it has ended in the middle of a model. Thread-safe.
 */
public final class ModelImportProcess implements AutoCloseable {
  private static final int BUFFER = 1 << 16;

  private final ImportLimits limits;
  private final List<String> command;
  private @Nullable Connection connection;

  /** Creates a reader that starts no process yet. */
  public ModelImportProcess(ImportLimits limits) {
    this(
        limits,
        ChildProcessCommand.contained(ModelImportMain.class.getName(), List.of("org.lwjgl.")));
  }

  ModelImportProcess(ImportLimits limits, List<String> command) {
    this.limits = limits;
    this.command = command;
  }

  /**
   * Starts the process unless it runs, without waiting for it.
   *
   * @throws IOException if it cannot be started
   */
  public synchronized void start() throws IOException {
    if (connection != null) {
      return;
    }
    Process process;
    try {
      process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    } catch (IOException e) {
      throw new IOException(
          "the process that reads models cannot be started: " + e.getMessage(), e);
    }
    connection = new Connection(process);
  }

  /**
   * Reads the meshes of a model, all in one frame, without nodes, cameras, lights and animations.
   *
   * @param name the name by which the model itself is asked for, whose extension tells the format
   * @param files the model's files
   * @return empty if it is damaged or not of the format that its name says
   * @throws IOException if a file cannot be read, or no process started
   * @throws ModelImportException if it exceeds a limit, or the process ends while it reads it
   */
  public Optional<ImportedModel> read(String name, ModelFileSource files)
      throws IOException, ModelImportException {
    return read(name, files, ImportProtocol.READ_MESHES);
  }

  /**
   * Reads a model with its nodes, cameras, lights and animations.
   *
   * @param name the name by which the model itself is asked for, whose extension tells the format
   * @param files the model's files
   * @return empty if it is damaged or not of the format that its name says
   * @throws IOException if a file cannot be read, or no process started
   * @throws ModelImportException if it exceeds a limit, or the process ends while it reads it
   */
  public Optional<ImportedModel> readScene(String name, ModelFileSource files)
      throws IOException, ModelImportException {
    return read(name, files, ImportProtocol.READ_SCENE);
  }

  private synchronized Optional<ImportedModel> read(String name, ModelFileSource files, int request)
      throws IOException, ModelImportException {
    start();
    Connection child = connection;
    if (child == null) {
      throw new IllegalStateException("the process has just been started");
    }
    boolean done = false;
    try (ChildProcessWatchdog watchdog =
        new ChildProcessWatchdog(
            child.process, "the model reader", limits.time(0), limits.memory(0))) {
      try {
        Optional<ImportedModel> model = new Dialogue(child, files, watchdog).model(name, request);
        done = true;
        return model;
      } catch (ChildException e) {
        throw new ModelImportException(
            watchdog.verdict().orElse("the model reader ended unexpectedly")
                + "; the file is probably damaged; nothing is read",
            e);
      }
    } finally {
      if (!done) {
        close();
      }
    }
  }

  /** Ends the process, if it runs. */
  @Override
  public synchronized void close() {
    if (connection != null) {
      connection.process.destroyForcibly();
      connection = null;
    }
  }

  /** Tells that the child process does not answer, or not what it should. */
  private static final class ChildException extends Exception {
    private static final long serialVersionUID = 1;

    ChildException(String message) {
      super(message);
    }

    ChildException(IOException cause) {
      super(cause);
    }
  }

  /** A running child process with its streams. */
  private static final class Connection {
    final Process process;
    private final DataInputStream in;
    private final DataOutputStream out;
    private boolean greeted;

    Connection(Process process) {
      this.process = process;
      in = new DataInputStream(new BufferedInputStream(process.getInputStream(), BUFFER));
      out = new DataOutputStream(new BufferedOutputStream(process.getOutputStream(), BUFFER));
    }

    /**
     * @throws IOException if the process can read no models
     */
    void send(String name, int request) throws IOException, ChildException {
      String fault = greeted ? "" : greeting();
      if (!fault.isEmpty()) {
        throw new IOException("models of other programs cannot be read: " + fault);
      }
      greeted = true;
      try {
        out.writeByte(request);
        out.writeUTF(name);
        out.flush();
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }

    private String greeting() throws ChildException {
      try {
        return in.readInt() == ImportProtocol.MAGIC && in.readInt() == ImportProtocol.VERSION
            ? in.readUTF()
            : "the process that was started is not one that reads models";
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }

    int answer() throws ChildException {
      try {
        return in.readByte();
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }

    String url() throws ChildException {
      try {
        return in.readUTF();
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }

    ImportedModel model(long maxBytes) throws ChildException, ModelImportException {
      try {
        return new ImportedModelDecoder(in, maxBytes).read();
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }

    void refuse() throws ChildException {
      try {
        out.writeByte(ImportProtocol.REFUSED);
        out.flush();
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }

    /**
     * @throws IOException if the file cannot be read
     */
    void serve(ModelFileSource.OpenFile file) throws IOException, ChildException {
      byte[] chunk = new byte[BUFFER];
      try {
        out.writeByte(ImportProtocol.SERVED);
        out.writeLong(file.size());
      } catch (IOException e) {
        throw new ChildException(e);
      }
      for (long left = file.size(); left > 0; ) {
        int part = file.content().read(chunk, 0, (int) Math.min(chunk.length, left));
        if (part < 0) {
          throw new IOException("a file has become shorter while it was read");
        }
        try {
          out.write(chunk, 0, part);
        } catch (IOException e) {
          throw new ChildException(e);
        }
        left -= part;
      }
      try {
        out.flush();
      } catch (IOException e) {
        throw new ChildException(e);
      }
    }
  }

  /** The dialogue with the child process about one model. */
  private final class Dialogue {
    private final Connection child;
    private final ModelFileSource files;
    private final ChildProcessWatchdog watchdog;
    private int openings;
    private long total;

    Dialogue(Connection child, ModelFileSource files, ChildProcessWatchdog watchdog) {
      this.child = child;
      this.files = files;
      this.watchdog = watchdog;
    }

    Optional<ImportedModel> model(String name, int request)
        throws IOException, ModelImportException, ChildException {
      child.send(name, request);
      while (true) {
        switch (child.answer()) {
          case ImportProtocol.OPEN -> serve(child.url());
          case ImportProtocol.MODEL -> {
            return Optional.of(child.model(limits.maxModelBytes()));
          }
          case ImportProtocol.UNREADABLE -> {
            return Optional.empty();
          }
          default -> throw new ChildException("the child process sent an unknown message");
        }
      }
    }

    private void serve(String url) throws IOException, ModelImportException, ChildException {
      if (++openings > limits.maxOpenings()) {
        throw new ModelImportException(
            "the model refers to other files more than %d times, which is the limit; it is not read"
                .formatted(limits.maxOpenings()));
      }
      Optional<ModelFileSource.OpenFile> file = files.open(url);
      if (file.isEmpty()) {
        child.refuse();
        return;
      }
      try (InputStream content = file.get().content()) {
        total += file.get().size();
        check(file.get().size(), limits.maxFileBytes(), "a file of the model is");
        check(total, limits.maxTotalBytes(), "the files of the model are together");
        watchdog.allow(limits.time(total), limits.memory(total));
        child.serve(new ModelFileSource.OpenFile(file.get().size(), content));
      }
    }

    private static void check(long bytes, long most, String subject) throws ModelImportException {
      if (bytes > most) {
        throw new ModelImportException(
            "%s larger than %d MiB, which is the limit; it is not read"
                .formatted(subject, most >> 20));
      }
    }
  }
}
