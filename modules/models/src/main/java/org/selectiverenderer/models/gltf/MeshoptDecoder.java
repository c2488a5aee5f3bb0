package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.util.meshoptimizer.MeshOptimizer;

/**
 * Decodes bufferViews that are compressed by EXT_meshopt_compression. meshoptimizer takes any bytes
 * without harm; the sizes, which it takes for granted, are checked here.
 */
final class MeshoptDecoder {
  private static final int MAX_STRIDE = 256;

  private final JsonNode extension;
  private final String path;

  /**
   * @param extension the extension of the bufferView
   * @param path its path, for messages
   */
  MeshoptDecoder(JsonNode extension, String path) {
    this.extension = extension;
    this.path = path;
  }

  /**
   * Returns the decoded bytes.
   *
   * @param packed the compressed bytes
   * @param most the number of bytes that they may become
   * @throws IOException if they are damaged or become too many, with one sentence
   */
  ByteBuffer decode(ByteBuffer packed, long most) throws IOException {
    long count = extension.path("count").asLong(-1);
    int stride = extension.path("byteStride").asInt(0);
    String mode = extension.path("mode").asText("");
    String filter = extension.path("filter").asText("NONE");
    if (!fits(mode, filter, count, stride) || count * stride > most) {
      throw damaged();
    }
    ByteBuffer in = MemoryUtil.memAlloc(Math.max(1, packed.remaining()));
    ByteBuffer out = MemoryUtil.memCalloc(Math.max(1, (int) (count * stride)));
    try {
      in.put(packed.duplicate()).flip();
      int error =
          switch (mode) {
            case "ATTRIBUTES" -> MeshOptimizer.meshopt_decodeVertexBuffer(out, count, stride, in);
            case "TRIANGLES" -> MeshOptimizer.meshopt_decodeIndexBuffer(out, count, stride, in);
            default -> MeshOptimizer.meshopt_decodeIndexSequence(out, count, stride, in);
          };
      if (error != 0) {
        throw damaged();
      }
      switch (filter) {
        case "OCTAHEDRAL" -> MeshOptimizer.meshopt_decodeFilterOct(out, count, stride);
        case "QUATERNION" -> MeshOptimizer.meshopt_decodeFilterQuat(out, count, stride);
        case "EXPONENTIAL" -> MeshOptimizer.meshopt_decodeFilterExp(out, count, stride);
        default -> {
          // as it is
        }
      }
      ByteBuffer decoded = ByteBuffer.allocate((int) (count * stride));
      decoded.put(out.limit(decoded.capacity())).flip();
      return decoded.order(ByteOrder.LITTLE_ENDIAN);
    } finally {
      MemoryUtil.memFree(in);
      MemoryUtil.memFree(out);
    }
  }

  private static boolean fits(String mode, String filter, long count, int stride) {
    if (count < 0 || count > Integer.MAX_VALUE || stride < 1 || stride > MAX_STRIDE) {
      return false;
    }
    boolean modeFits =
        switch (mode) {
          case "ATTRIBUTES" -> stride % 4 == 0;
          case "TRIANGLES" -> (stride == 2 || stride == 4) && count % 3 == 0;
          case "INDICES" -> stride == 2 || stride == 4;
          default -> false;
        };
    boolean filterFits =
        switch (filter) {
          case "NONE" -> true;
          case "OCTAHEDRAL" -> stride == 4 || stride == 8;
          case "QUATERNION" -> stride == 8;
          case "EXPONENTIAL" -> stride % 4 == 0;
          default -> false;
        };
    return modeFits && filterFits && (filter.equals("NONE") || mode.equals("ATTRIBUTES"));
  }

  private IOException damaged() {
    return new IOException(path + " is damaged or too large, so that it cannot be unpacked");
  }
}
