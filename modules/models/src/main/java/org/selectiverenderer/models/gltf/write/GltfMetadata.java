package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Writes the metadata of a node into the {@code extras} of a glTF object, so that the schemas of an
 * enriched scene are not lost: {@code extras.x3d} has the type of the node and {@code metadata},
 * which has {@code type}, {@code name}, {@code reference}, {@code value} and possibly {@code
 * metadata} (X3D 4.0, 7.2.4).
 */
final class GltfMetadata {
  private static final int DEEPEST = 100;

  private final GltfDocument document;
  private final GltfLosses losses;

  GltfMetadata(GltfDocument document, GltfLosses losses) {
    this.document = document;
    this.losses = losses;
  }

  /** Adds the metadata of a node, if it has any. */
  void append(NodeView node, ObjectNode to) throws IOException {
    if (node.type().field("metadata").isPresent() && node.node("metadata") != null) {
      NodeView metadata = node.node("metadata");
      ObjectNode extras = extras(node, to);
      if (metadata != null && !extras.has("metadata")) {
        put(metadata, extras.putObject("metadata"), 0);
      }
    }
  }

  /** Returns the object in {@code extras} that holds what only X3D knows about a node. */
  static ObjectNode extras(NodeView node, ObjectNode to) {
    ObjectNode extras = to.withObject("/extras").withObject("/x3d");
    return extras.put("type", node.type().name());
  }

  private void put(NodeView metadata, ObjectNode out, int depth) throws IOException {
    document.countNode();
    if (depth > DEEPEST) {
      losses.tell(
          "deep metadata",
          metadata.location(),
          "metadata is nested more than %d deep; what is inside is left out".formatted(DEEPEST));
      return;
    }
    out.put("type", metadata.type().name());
    if (metadata.name() != null) {
      out.put("DEF", metadata.name());
    }
    document.countValue(metadata.string("name"));
    out.put("name", metadata.string("name"));
    if (!metadata.string("reference").isEmpty()) {
      document.countValue(metadata.string("reference"));
      out.put("reference", metadata.string("reference"));
    }
    ArrayNode values = out.putArray("value");
    switch (metadata.type().name()) {
      case "MetadataSet" -> {
        for (NodeView node : metadata.nodes("value")) {
          put(node, values.addObject(), depth + 1);
        }
      }
      case "MetadataString" -> {
        for (String value : metadata.strings("value")) {
          document.countValue(value);
          values.add(value);
        }
      }
      case "MetadataInteger" -> {
        for (int value : metadata.ints("value")) {
          document.countValue("");
          values.add(value);
        }
      }
      case "MetadataFloat" -> {
        for (float value : metadata.floats("value")) {
          document.countValue("");
          values.add(GltfDocument.finite(Double.parseDouble(Float.toString(value))));
        }
      }
      case "MetadataDouble" -> {
        if (metadata.value("value") instanceof double[] doubles) {
          for (double value : doubles) {
            document.countValue("");
            values.add(GltfDocument.finite(value));
          }
        }
      }
      case "MetadataBoolean" -> {
        if (metadata.value("value") instanceof boolean[] flags) {
          for (boolean value : flags) {
            document.countValue("");
            values.add(value);
          }
        }
      }
      default -> losses.node(metadata);
    }
    NodeView more = metadata.node("metadata");
    if (more != null) {
      put(more, out.putObject("metadata"), depth + 1);
    }
  }
}
