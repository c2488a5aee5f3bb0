package org.selectiverenderer.radiosity.scene;

import java.util.Optional;
import java.util.SortedSet;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The values that a scene gives for radiosity in metadata: a MetadataSet named {@code photometric}
 * on a light, or one named {@code radiosity} on a group or Inline, alone or inside another
 * MetadataSet.
 */
final class PhotometricMetadata {
  private final NodeViewMetadata set;

  private PhotometricMetadata(NodeViewMetadata set) {
    this.set = set;
  }

  /**
   * Returns the values of a node; empty if it has no such set.
   *
   * @param members the names that the set may contain; other names and impossible values are
   *     reported to {@code problems} and ignored
   */
  static Optional<PhotometricMetadata> of(
      NodeView node, String name, SortedSet<String> members, ProblemCollector problems) {
    if (node.type().field("metadata").isEmpty()) {
      return Optional.empty();
    }
    return NodeViewMetadata.of(node).stream()
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

  private void check(SortedSet<String> members, ProblemCollector problems) {
    for (NodeViewMetadata child : set.children()) {
      String member = child.name();
      if (!members.contains(member)) {
        problems.warning(
            child.node().location(),
            "the MetadataSet %s has no member %s, so it is ignored; known members are %s"
                .formatted(set.name(), member, String.join(", ", members)));
      } else if (numbers(member).filter(values -> values.length > 0).isEmpty()) {
        problems.warning(
            child.node().location(),
            "%s must be a number above 0; it is ignored".formatted(member));
      }
    }
  }

  /**
   * Returns the first number of a member; empty if there is none, or if a value is not a finite
   * number above 0.
   */
  Optional<Double> number(String member) {
    return numbers(member).filter(values -> values.length > 0).map(values -> values[0]);
  }

  /** Returns all numbers of a member; empty unless each is finite and above 0. */
  Optional<double[]> numbers(String member) {
    for (NodeViewMetadata child : set.children()) {
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
