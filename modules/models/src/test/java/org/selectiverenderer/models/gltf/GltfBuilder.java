package org.selectiverenderer.models.gltf;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;

/** Builds small glTF files; accessors are numbered in the order in which they are added. */
final class GltfBuilder {
  private final ByteArrayOutputStream data = new ByteArrayOutputStream();
  private final List<String> views = new ArrayList<>();
  private final List<String> accessors = new ArrayList<>();

  /** Adds an accessor of floats. */
  GltfBuilder floats(String type, int count, float... values) {
    ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (float value : values) {
      bytes.putFloat(value);
    }
    return accessor(view(bytes.array(), 0), 5126, type, count, "");
  }

  /** Adds an accessor of unsigned shorts. */
  GltfBuilder shorts(String type, int count, String more, int... values) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int value : values) {
      bytes.putShort((short) value);
    }
    return accessor(view(bytes.array(), 0), 5123, type, count, more);
  }

  /** Adds a triangle in the plane z = 0, with an accessor of its points. */
  GltfBuilder triangle() {
    return floats("VEC3", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0);
  }

  /** Adds a bufferView and returns its index. */
  int view(byte[] bytes, int stride) {
    while (data.size() % 4 != 0) {
      data.write(0);
    }
    String more = stride > 0 ? ",\"byteStride\":" + stride : "";
    views.add(
        "{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":%d%s}"
            .formatted(data.size(), bytes.length, more));
    data.writeBytes(bytes);
    return views.size() - 1;
  }

  /**
   * Adds an accessor.
   *
   * @param more further members, beginning with a comma
   */
  GltfBuilder accessor(int view, int componentType, String type, int count, String more) {
    accessors.add(
        "{\"bufferView\":%d,\"componentType\":%d,\"type\":\"%s\",\"count\":%d%s}"
            .formatted(view, componentType, type, count, more));
    return this;
  }

  /** Adds an accessor without bytes of its own. */
  GltfBuilder empty(int componentType, String type, int count, String more) {
    accessors.add(
        "{\"componentType\":%d,\"type\":\"%s\",\"count\":%d%s}"
            .formatted(componentType, type, count, more));
    return this;
  }

  /** Returns glTF in JSON, with its numbers in a data url. */
  String json(String members) {
    String uri = Base64.getEncoder().encodeToString(data.toByteArray());
    return json(members, ",\"uri\":\"data:application/octet-stream;base64," + uri + '"');
  }

  /** Returns glTF in JSON, with its numbers in another file. */
  String json(String members, String buffer) {
    return "{\"asset\":{\"version\":\"2.0\"},%s,\"accessors\":[%s],\"bufferViews\":[%s],\"buffers\":[{\"byteLength\":%d%s}]}"
        .formatted(
            members, String.join(",", accessors), String.join(",", views), data.size(), buffer);
  }

  /** Returns glTF in binary. */
  byte[] binary(String members) {
    byte[] text = json(members, "").getBytes(StandardCharsets.UTF_8);
    int padding = -text.length & 3;
    int length = text.length + padding;
    int size = data.size() + (-data.size() & 3);
    ByteBuffer file = ByteBuffer.allocate(28 + length + size).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546C67).putInt(2).putInt(file.capacity()).putInt(length).putInt(0x4E4F534A);
    file.put(text).put(" ".repeat(padding).getBytes(StandardCharsets.UTF_8));
    file.putInt(size).putInt(0x4E4942).put(data.toByteArray());
    return file.array();
  }
}
