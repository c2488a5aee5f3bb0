package org.selectiverenderer.models.importer;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.lwjgl.assimp.AIFile;
import org.lwjgl.assimp.AIFileCloseProc;
import org.lwjgl.assimp.AIFileFlushProc;
import org.lwjgl.assimp.AIFileIO;
import org.lwjgl.assimp.AIFileOpenProc;
import org.lwjgl.assimp.AIFileReadProc;
import org.lwjgl.assimp.AIFileSeek;
import org.lwjgl.assimp.AIFileTellProc;
import org.lwjgl.assimp.AIFileWriteProc;
import org.lwjgl.assimp.Assimp;
import org.lwjgl.system.MemoryUtil;

/**
 * Gives Assimp the files that the parent process serves, in the place of those of the disk. Its
 * functions are called by native code, to which no exception may get out.
 */
final class ServedFileIo implements AutoCloseable {
  /** An open file: its bytes in native memory, and the place of the next one to be read. */
  private static final class Served {
    final ByteBuffer bytes;
    long at;

    Served(ByteBuffer bytes) {
      this.bytes = bytes;
    }
  }

  private final DataInputStream in;
  private final DataOutputStream out;
  private final Map<Long, Served> open = new HashMap<>();
  private final Served nothing = new Served(ByteBuffer.allocateDirect(0));
  private @Nullable IOException failure;

  private final AIFileReadProc read = AIFileReadProc.create(this::read);
  private final AIFileWriteProc write = AIFileWriteProc.create((file, from, size, count) -> 0);
  private final AIFileTellProc tell = AIFileTellProc.create(file -> served(file).at);
  private final AIFileTellProc size = AIFileTellProc.create(file -> served(file).bytes.capacity());
  private final AIFileSeek seek = AIFileSeek.create(this::seek);
  private final AIFileFlushProc flush = AIFileFlushProc.create(file -> {});
  private final AIFileOpenProc opening = AIFileOpenProc.create(this::open);
  private final AIFileCloseProc closing = AIFileCloseProc.create((io, file) -> close(file));
  private final AIFileIO io = AIFileIO.calloc().set(opening, closing, 0);

  ServedFileIo(DataInputStream in, DataOutputStream out) {
    this.in = in;
    this.out = out;
  }

  AIFileIO io() {
    return io;
  }

  /**
   * @throws IOException if the parent process could not be asked for a file
   */
  void check() throws IOException {
    if (failure != null) {
      throw failure;
    }
  }

  private long open(long fileIo, long name, long mode) {
    if (failure != null || MemoryUtil.memASCII(mode).indexOf('r') < 0) {
      return 0;
    }
    try {
      ByteBuffer bytes = ask(MemoryUtil.memUTF8(name));
      if (bytes == null) {
        return 0;
      }
      AIFile file = AIFile.calloc().set(read, write, tell, size, seek, flush, 0);
      open.put(file.address(), new Served(bytes));
      return file.address();
    } catch (IOException | OutOfMemoryError e) {
      failure = new IOException("a file cannot be got from the parent process", e);
      return 0;
    }
  }

  private @Nullable ByteBuffer ask(String url) throws IOException {
    out.writeByte(ImportProtocol.OPEN);
    out.writeUTF(url.substring(0, Math.min(url.length(), ImportProtocol.MAX_URL)));
    out.flush();
    if (in.readByte() != ImportProtocol.SERVED) {
      return null;
    }
    ByteBuffer bytes = MemoryUtil.memAlloc(Math.toIntExact(in.readLong()));
    byte[] chunk = new byte[1 << 16];
    for (int at = 0; at < bytes.capacity(); ) {
      int part = Math.min(chunk.length, bytes.capacity() - at);
      in.readFully(chunk, 0, part);
      bytes.put(at, chunk, 0, part);
      at += part;
    }
    return bytes;
  }

  private Served served(long file) {
    return open.getOrDefault(file, nothing);
  }

  private long read(long file, long to, long size, long count) {
    Served served = served(file);
    if (size <= 0 || count <= 0) {
      return 0;
    }
    long items = Math.min(count, (served.bytes.capacity() - served.at) / size);
    if (items > 0) {
      MemoryUtil.memCopy(
          MemoryUtil.memAddress0(served.bytes) + served.at, to, Math.multiplyExact(items, size));
      served.at += items * size;
    }
    return items;
  }

  private int seek(long file, long offset, int origin) {
    Served served = served(file);
    long from =
        switch (origin) {
          case Assimp.aiOrigin_SET -> 0;
          case Assimp.aiOrigin_CUR -> served.at;
          default -> served.bytes.capacity();
        };
    long to = from + offset;
    if (to < 0 || to > served.bytes.capacity()) {
      return Assimp.aiReturn_FAILURE;
    }
    served.at = to;
    return Assimp.aiReturn_SUCCESS;
  }

  private void close(long file) {
    Served served = open.remove(file);
    if (served != null) {
      MemoryUtil.memFree(served.bytes);
      AIFile.create(file).free();
    }
  }

  @Override
  public void close() {
    open.keySet().stream().toList().forEach(this::close);
    io.free();
    read.free();
    write.free();
    tell.free();
    size.free();
    seek.free();
    flush.free();
    opening.free();
    closing.free();
  }
}
