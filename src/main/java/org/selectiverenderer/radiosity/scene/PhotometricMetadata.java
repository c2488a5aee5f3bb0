package org.selectiverenderer.radiosity.scene;

import java.util.Optional;
import java.util.SortedSet;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.schema.nodes.NodeMetadata;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * What a scene asks of the light, in metadata: a MetadataSet named {@code photometric} on a light
 * and one named {@code radiosity} on a group or Inline; alone or among other metadata.
 */
final class PhotometricMetadata {
  private final NodeMetadata set;

  private PhotometricMetadata(NodeMetadata set) {
    this.set = set;
  }

  /**
   * What a node asks for.
   *
   * @param members that the set may have; of others, and of values that none can have, the problems
   *     hear, and they are passed over
   */
  static Optional<PhotometricMetadata> of(
      NodeView node, String name, SortedSet<String> members, Problems problems) {
    if (node.type().field("metadata").isEmpty()) {
      return Optional.empty();
    }
    return NodeMetadata.of(node).stream()
        .flatMap(own -> Stream.concat(Stream.of(own), own.children().stream()))
        .filter(data -> data.isSet() && data.name().equals(name))
        .findFirst()
        .map(
            data -> {
              PhotometricMetadata wishes = new PhotometricMetadata(data);
              wishes.check(members, problems);
              return wishes;
            });
  }

  private void check(SortedSet<String> members, Problems problems) {
    for (NodeMetadata child : set.children()) {
      String member = child.name();
      if (!members.contains(member)) {
        problems.warning(
            child.node().location(),
            "the metadata %s has no member %s, so it is ignored; known members are %s"
                .formatted(set.name(), member, String.join(", ", members)));
      } else if (numbers(member).filter(values -> values.length > 0).isEmpty()) {
        problems.warning(
            child.node().location(),
            "%s must be a number above 0; it is ignored".formatted(member));
      }
    }
  }

  /** The first number of a member; empty if there is none, or if it is no finite number above 0. */
  Optional<Double> number(String member) {
    return numbers(member).filter(values -> values.length > 0).map(values -> values[0]);
  }

  /** All numbers of a member, each finite and above 0. */
  Optional<double[]> numbers(String member) {
    for (NodeMetadata child : set.children()) {
      if (child.name().equals(member)) {
        try {
          double[] values = child.values().stream().mapToDouble(Double::parseDouble).toArray();
          for (double value : values) {
            if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
              return Optional.empty();
            }
          }
          return Optional.of(values);
        } catch (NumberFormatException e) {
          return Optional.empty();
        }
      }
    }
    return Optional.empty();
  }
}
