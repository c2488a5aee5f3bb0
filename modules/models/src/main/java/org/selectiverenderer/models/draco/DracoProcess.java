package org.selectiverenderer.models.draco;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.base.platform.ChildProcessWatchdog;

/**
 * Decodes the meshes of one model in a child process, which is started with the first of them. Not
 * thread-safe.
 */
public final class DracoProcess implements AutoCloseable {
  /** The heap of the child, in which a mesh of two million triangles with normals fits. */
  private static final int HEAP_MIB = 512;

  /** The heap and what the virtual machine itself takes. */
  private static final long MEMORY = (HEAP_MIB + 256L) << 20;

  private static final Duration TIME = Duration.ofSeconds(10);
  private static final Duration TIME_PER_MEBIBYTE = Duration.ofSeconds(5);

  private static final String DAMAGED = "its Draco data are damaged";

  private final Duration time;
  private long bytes;
  private long nanos;
  private @Nullable Process process;
  private @Nullable String failure;

  /**
   * Creates a decoder that starts no process yet, with 10 s for all meshes of the model, 5 s more
   * for each MiB of their compressed bytes, and 768 MiB of memory.
   */
  public DracoProcess() {
    this(TIME);
  }

  DracoProcess(Duration time) {
    this.time = time;
  }

  /**
   * Decodes a mesh.
   *
   * @param packed the compressed bytes
   * @param most how many values it may have, indices included
   * @throws IOException if it is damaged, beyond a limit, or the process has ended, with a sentence
   *     without a full stop
   */
  public DracoMesh decode(byte[] packed, long most) throws IOException {
    if (failure != null) {
      throw new IOException(failure);
    }
    Process child = started();
    bytes += packed.length;
    long start = System.nanoTime();
    try (ChildProcessWatchdog watchdog =
        new ChildProcessWatchdog(child, "the decoder of Draco", left(), MEMORY)) {
      try {
        return dialogue(child, packed, most);
      } catch (IOException e) {
        close();
        failure =
            "its Draco data are not read, since %s at damaged data"
                .formatted(watchdog.verdict().orElse("their decoder ended unexpectedly"));
        throw new IOException(failure, e);
      }
    } catch (DamagedException e) {
      throw new IOException(e.getMessage(), e);
    } finally {
      nanos += System.nanoTime() - start;
    }
  }

  private Duration left() {
    Duration left = time.plus(TIME_PER_MEBIBYTE.multipliedBy(bytes >> 20)).minusNanos(nanos);
    return left.isNegative() ? Duration.ZERO : left;
  }

  private Process started() throws IOException {
    Process child = process;
    if (child == null) {
      List<String> command =
          ChildProcessCommand.contained(DracoMain.class.getName(), HEAP_MIB, List.of());
      try {
        child = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
      } catch (IOException e) {
        failure = "the process that decodes Draco cannot be started: " + e.getMessage();
        throw new IOException(failure, e);
      }
      process = child;
    }
    return child;
  }

  /** Tells that a mesh cannot be decoded, after which the child decodes others. */
  private static final class DamagedException extends Exception {
    private static final long serialVersionUID = 1;

    DamagedException(String message) {
      super(message);
    }
  }

  private static DracoMesh dialogue(Process child, byte[] packed, long most)
      throws IOException, DamagedException {
    // The child reads the whole request before it answers, and nothing is left in the buffers.
    DataOutputStream out =
        new DataOutputStream(
            new BufferedOutputStream(child.getOutputStream(), DracoProtocol.BUFFER));
    out.writeLong(most);
    out.writeInt(packed.length);
    out.write(packed);
    out.flush();
    DataInputStream in =
        new DataInputStream(new BufferedInputStream(child.getInputStream(), DracoProtocol.BUFFER));
    return switch (in.readByte()) {
      case DracoProtocol.MESH -> mesh(in, most);
      case DracoProtocol.TOO_LARGE ->
          throw new DamagedException("its Draco data become more numbers than fit into the memory");
      case DracoProtocol.DAMAGED -> throw new DamagedException(DAMAGED);
      default -> throw new IOException("the child process sent an unknown message");
    };
  }

  private static DracoMesh mesh(DataInputStream in, long most) throws IOException {
    int points = in.readInt();
    int corners = count(in.readInt(), most);
    long left = most - corners;
    int[] indices = new int[corners];
    for (int i = 0; i < corners; i++) {
      indices[i] = in.readInt();
    }
    int attributes = count(in.readInt(), DracoProtocol.MAX_ATTRIBUTES);
    List<DracoMesh.Attribute> read = new ArrayList<>();
    for (int a = 0; a < attributes; a++) {
      int id = in.readInt();
      int components = count(in.readInt(), DracoProtocol.MAX_COMPONENTS);
      boolean integers = in.readBoolean();
      float[] values = new float[count((long) points * components, left)];
      left -= values.length;
      for (int i = 0; i < values.length; i++) {
        values[i] = in.readFloat();
      }
      read.add(new DracoMesh.Attribute(id, components, integers, values));
    }
    return new DracoMesh(points, indices, read);
  }

  private static int count(long count, long most) throws IOException {
    if (count < 0 || count > Math.min(most, Integer.MAX_VALUE - 8)) {
      throw new IOException("the child process sent a number that is out of range");
    }
    return (int) count;
  }

  /** Ends the process, if it runs. */
  @Override
  public void close() {
    if (process != null) {
      process.destroyForcibly();
      process = null;
    }
  }
}
