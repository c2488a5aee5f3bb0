package org.selectiverenderer.polygon.metadata;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.MetadataNode;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Adapts a metadata node of a file or of the embedded browser's scene.
 *
 * @param node a node whose type is an X3DMetadataObject
 */
public record NodeViewMetadata(NodeView node) implements MetadataNode {
  /** Returns the metadata of a node, if it has any. */
  public static Optional<NodeViewMetadata> of(NodeView owner) {
    return Optional.ofNullable(owner.node("metadata"))
        .filter(metadata -> metadata.type().is("X3DMetadataObject"))
        .map(NodeViewMetadata::new);
  }

  @Override
  public boolean isSet() {
    return node.type().name().equals("MetadataSet");
  }

  @Override
  public String name() {
    return node.string("name");
  }

  @Override
  public List<String> values() {
    if (isSet()) {
      return List.of();
    }
    Object array = node.value("value");
    List<String> values = new ArrayList<>();
    for (int i = 0; array != null && i < Array.getLength(array); i++) {
      values.add(String.valueOf(Array.get(array, i)));
    }
    return values;
  }

  @Override
  public Optional<NodeViewMetadata> metadata() {
    return of(node);
  }

  @Override
  public List<NodeViewMetadata> children() {
    List<NodeViewMetadata> children = new ArrayList<>();
    if (isSet()) {
      for (NodeView child : node.nodes("value")) {
        if (child.type().is("X3DMetadataObject")) {
          children.add(new NodeViewMetadata(child));
        }
      }
    }
    return children;
  }
}
