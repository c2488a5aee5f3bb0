package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;
import org.selectiverenderer.models.draco.DracoMesh;
import org.selectiverenderer.models.draco.DracoProcess;

/**
 * Gives accessors the values of primitives that are compressed by KHR_draco_mesh_compression, whose
 * accessors have no bytes of their own.
 */
final class GltfDraco implements AutoCloseable {
  private static final String EXTENSION = "KHR_draco_mesh_compression";

  /**
   * Offset of the byte in Draco's header that names the method, and its value for the sequential
   * one.
   */
  private static final int METHOD = 8;

  private static final int SEQUENTIAL = 0;

  private final GltfFile file;
  private final GltfAccessors accessors;
  private final DracoProcess process = new DracoProcess();

  GltfDraco(GltfFile file, GltfAccessors accessors) {
    this.file = file;
    this.accessors = accessors;
  }

  /**
   * Decodes a primitive, if it is compressed and not there without compression besides, until
   * {@link GltfAccessors#forgetUnpacked}.
   *
   * @throws IOException if it cannot be decoded, with a sentence without a full stop
   */
  void unpack(JsonNode primitive) throws IOException {
    JsonNode packed = primitive.path("extensions").path(EXTENSION);
    JsonNode attributes = primitive.path("attributes");
    if (!packed.isObject() || !isEmpty(GltfFile.index(attributes, "POSITION"))) {
      return;
    }
    int indices = GltfFile.index(primitive, "indices");
    if (!isEmpty(indices)) {
      throw new IOException("its Draco data need an accessor of indices without a bufferView");
    }
    ByteBuffer view = file.view(GltfFile.index(packed, "bufferView"));
    byte[] bytes = new byte[view.remaining()];
    view.get(bytes);
    if (!primitive.path("targets").isEmpty() && !keepsOrder(bytes)) {
      throw new IOException(
          "it has morph targets, but Draco's method edgebreaker changes the order of vertices");
    }
    DracoMesh mesh = process.decode(bytes, accessors.left());
    for (Map.Entry<String, JsonNode> entry : packed.path("attributes").properties()) {
      int accessor = GltfFile.index(attributes, entry.getKey());
      DracoMesh.Attribute found = mesh.attribute(entry.getValue().asInt(-1)).orElse(null);
      if (isEmpty(accessor) && found != null) {
        if (found.components() != accessors.components(accessor)) {
          throw new IOException("its Draco data do not fit accessors[%d]".formatted(accessor));
        }
        float[] values = found.values();
        accessors.unpacked(accessor, values.length, found.integers(), i -> values[i]);
      }
    }
    if (!accessors.isUnpacked(GltfFile.index(attributes, "POSITION"))) {
      throw new IOException("its Draco data have no positions");
    }
    int[] corners = mesh.indices();
    accessors.unpacked(indices, corners.length, true, i -> corners[i]);
  }

  private boolean isEmpty(int accessor) {
    JsonNode found = file.part("accessors", accessor);
    return found.isObject() && !found.has("bufferView");
  }

  private static boolean keepsOrder(byte[] bytes) {
    return bytes.length > METHOD && bytes[METHOD] == SEQUENTIAL;
  }

  /** Ends the process that decodes, if it runs. */
  @Override
  public void close() {
    process.close();
  }
}
