package org.selectiverenderer.browser.scene;

import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Finds metadata by which a scene tells this browser something of a node, and which others pass
 * over.
 */
public final class NamedMetadata {
  private NamedMetadata() {}

  /**
   * Returns the metadata node of a name: the owner's metadata itself, or a member of the
   * MetadataSet that it is.
   *
   * @param type the type of the metadata node, such as {@code MetadataString}
   */
  public static Optional<Node> find(Node owner, String type, String name) {
    Node metadata = owner.node("metadata");
    if (metadata == null) {
      return Optional.empty();
    }
    Stream<Node> candidates =
        metadata.type().name().equals("MetadataSet")
            ? metadata.nodes("value").stream()
            : Stream.of(metadata);
    return candidates.filter(node -> named(node, type, name)).findFirst();
  }

  private static boolean named(@Nullable Node node, String type, String name) {
    return node != null
        && node.type().name().equals(type)
        && node.string("name").strip().equals(name);
  }
}
