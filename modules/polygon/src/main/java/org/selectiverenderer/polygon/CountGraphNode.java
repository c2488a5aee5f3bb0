package org.selectiverenderer.polygon;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A node of the count graph: a group, a shape or an area of a scene, with the contents of its
 * Inlines. A node that is USEd, or a file that is inlined several times, is one graph node with
 * several parents, so that its counts are computed once. Compared by identity.
 */
final class CountGraphNode implements ChoiceKey {
  final @Nullable ParsedNode node;
  final String name;
  final List<CountGraphNode> children;
  final Optional<Matrix4d> placement;
  final Optional<SwitchSchemas> versions;
  final Optional<SensorSchemas> area;

  /** The bounding box of all versions together, in the coordinates of the parent. */
  final BoundingBox bounds;

  /** Whether the bounds are tight: nothing in the node is rotated by other than right angles. */
  final boolean exact;

  /** Whether the node is a versioned object or contains one. */
  final boolean varies;

  /** Polygons outside of versioned objects; all polygons if the node does not vary. */
  final long polygons;

  /** Shapes that are drawn outside of versioned objects; all if the node does not vary. */
  final long drawCalls;

  private final List<TextureUse> ownTextures;
  private @Nullable Set<TextureUse> textures;

  private CountGraphNode(Builder from) {
    node = from.node;
    name = from.name;
    children = List.copyOf(from.children);
    placement = from.placement;
    versions = from.versions;
    area = from.area;
    varies = versions.isPresent() || children.stream().anyMatch(child -> child.varies);
    BoundingBox inside = from.size.bounds();
    for (CountGraphNode child : children) {
      inside = inside.union(child.bounds);
    }
    exact =
        placement.map(CountGraphNode::keepsBoxes).orElse(true)
            && children.stream().allMatch(child -> child.exact);
    bounds = placement.isPresent() ? inside.transformed(placement.get()) : inside;
    polygons = varies ? 0 : plus(ownPolygons(from), sum(shown(whichChoice())));
    ownTextures = List.copyOf(from.textures);
    long draws = from.drawn && visible() ? 1 : 0;
    for (CountGraphNode child : varies ? List.<CountGraphNode>of() : shown(whichChoice())) {
      draws = plus(draws, child.drawCalls);
    }
    drawCalls = draws;
  }

  private boolean visible() {
    return node == null || DrawableNodeClassifier.visible(node);
  }

  /** Returns the textures of all shapes that a node shows which does not vary. */
  Set<TextureUse> textures() {
    Set<TextureUse> known = textures;
    if (known == null) {
      known = new HashSet<>(visible() ? ownTextures : List.of());
      for (CountGraphNode child : shown(whichChoice())) {
        known.addAll(child.textures());
      }
      textures = known;
    }
    return known;
  }

  /** Returns whether a matrix maps axis-aligned boxes to axis-aligned boxes. */
  private static boolean keepsBoxes(Matrix4d matrix) {
    for (int column = 0; column < 3; column++) {
      int entries = 0;
      for (int row = 0; row < 3; row++) {
        entries += Math.abs(matrix.get(column, row)) > 1e-6 ? 1 : 0;
      }
      if (entries > 1) {
        return false;
      }
    }
    return true;
  }

  private static long ownPolygons(Builder from) {
    return from.node != null && !DrawableNodeClassifier.visible(from.node)
        ? 0
        : from.size.polygons();
  }

  private static long sum(List<CountGraphNode> items) {
    long sum = 0;
    for (CountGraphNode item : items) {
      sum = plus(sum, item.polygons);
    }
    return sum;
  }

  /** Returns the sum, saturated at the largest number, since nested USEs multiply without bound. */
  static long plus(long a, long b) {
    long sum = a + b;
    return sum < 0 ? Long.MAX_VALUE : sum;
  }

  /** Returns whether the node has a DEF name by which it can be chosen. */
  boolean isNamed() {
    return node != null && node.name() != null;
  }

  /** Returns whichChoice of a Switch as in the file; -1 for other nodes. */
  int whichChoice() {
    return node != null && DrawableNodeClassifier.isSwitch(node) ? node.integer("whichChoice") : -1;
  }

  /**
   * Returns the children that are drawn; of an LOD only the most detailed one.
   *
   * @param choice the choice of a Switch
   */
  List<CountGraphNode> shown(int choice) {
    if (node == null) {
      return children;
    }
    if (!DrawableNodeClassifier.visible(node)) {
      return List.of();
    }
    return switch (node.type().name()) {
      case "Switch" -> choice >= 0 && choice < children.size() ? slice(choice) : List.of();
      case "LOD" -> children.isEmpty() ? children : slice(0);
      default -> children;
    };
  }

  private List<CountGraphNode> slice(int index) {
    return children.subList(index, index + 1);
  }

  /** Builds a node of the count graph. */
  static final class Builder {
    private final @Nullable ParsedNode node;
    private String name = "";
    private List<CountGraphNode> children = List.of();
    private Optional<Matrix4d> placement = Optional.empty();
    private Optional<SwitchSchemas> versions = Optional.empty();
    private Optional<SensorSchemas> area = Optional.empty();
    private GeometrySize size = GeometrySize.NOTHING;
    private boolean drawn;
    private List<TextureUse> textures = List.of();

    /**
     * @param node null for the root of a file
     */
    Builder(@Nullable ParsedNode node) {
      this.node = node;
    }

    Builder name(String called) {
      name = called;
      return this;
    }

    Builder children(List<CountGraphNode> inside) {
      children = inside;
      return this;
    }

    Builder placement(Matrix4d matrix) {
      placement = Optional.of(matrix);
      return this;
    }

    Builder versions(Optional<SwitchSchemas> schemas) {
      versions = schemas;
      return this;
    }

    Builder area(Optional<SensorSchemas> schemas) {
      area = schemas;
      return this;
    }

    Builder size(GeometrySize measured) {
      size = measured;
      return this;
    }

    /** Makes it a shape that is drawn. */
    Builder drawn(List<TextureUse> shown) {
      drawn = true;
      textures = shown;
      return this;
    }

    CountGraphNode build() {
      return new CountGraphNode(this);
    }
  }
}
