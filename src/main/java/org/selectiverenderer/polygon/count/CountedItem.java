package org.selectiverenderer.polygon.count;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A group, a shape or an area of a scene, Inlines filled. A node that is USEd is one item in
 * several places, and so is a file that is inlined several times: what is known of an item is found
 * out once. Compared by identity.
 */
final class CountedItem {
  final @Nullable ParsedNode node;
  final String name;
  final List<CountedItem> children;
  final Optional<Matrix4d> placement;
  final Optional<SwitchSchemas> versions;
  final Optional<SensorSchemas> area;

  /** Of all versions together, in the coordinates of whatever holds the item. */
  final Bounds bounds;

  /** Whether the bounds are the least: nothing in it is turned by other than right angles. */
  final boolean exact;

  /** Whether it is an object in versions or holds one. */
  final boolean varies;

  /** Polygons shown when no object in versions is looked at: all of them unless it varies. */
  final long polygons;

  private CountedItem(Builder from) {
    node = from.node;
    name = from.name;
    children = List.copyOf(from.children);
    placement = from.placement;
    versions = from.versions;
    area = from.area;
    varies = versions.isPresent() || children.stream().anyMatch(child -> child.varies);
    Bounds inside = from.size.bounds();
    for (CountedItem child : children) {
      inside = inside.union(child.bounds);
    }
    exact =
        placement.map(CountedItem::keepsBoxes).orElse(true)
            && children.stream().allMatch(child -> child.exact);
    bounds = placement.isPresent() ? inside.transformed(placement.get()) : inside;
    polygons = varies ? 0 : plus(ownPolygons(from), sum(shown(whichChoice())));
  }

  /** Whether boxes along the axes stay boxes along the axes. */
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
    return from.node != null && !Structure.visible(from.node) ? 0 : from.size.polygons();
  }

  private static long sum(List<CountedItem> items) {
    long sum = 0;
    for (CountedItem item : items) {
      sum = plus(sum, item.polygons);
    }
    return sum;
  }

  /** Nested USEs multiply without bound: the sum stays at the largest number. */
  static long plus(long a, long b) {
    long sum = a + b;
    return sum < 0 ? Long.MAX_VALUE : sum;
  }

  /** Whether it has a name of its own by which it can be chosen. */
  boolean isNamed() {
    return node != null && node.name() != null;
  }

  /** The choice that the file gives a Switch; -1 for other nodes. */
  int whichChoice() {
    return node != null && Structure.isSwitch(node) ? node.integer("whichChoice") : -1;
  }

  /**
   * The children that are drawn. Of a LOD that is the most detailed one.
   *
   * @param choice for a Switch
   */
  List<CountedItem> shown(int choice) {
    if (node == null) {
      return children;
    }
    if (!Structure.visible(node)) {
      return List.of();
    }
    return switch (node.type().name()) {
      case "Switch" -> choice >= 0 && choice < children.size() ? slice(choice) : List.of();
      case "LOD" -> children.isEmpty() ? children : slice(0);
      default -> children;
    };
  }

  private List<CountedItem> slice(int index) {
    return children.subList(index, index + 1);
  }

  /** What an item is made of. */
  static final class Builder {
    private final @Nullable ParsedNode node;
    private String name = "";
    private List<CountedItem> children = List.of();
    private Optional<Matrix4d> placement = Optional.empty();
    private Optional<SwitchSchemas> versions = Optional.empty();
    private Optional<SensorSchemas> area = Optional.empty();
    private Size size = Size.NOTHING;

    /**
     * @param node null for a file's top
     */
    Builder(@Nullable ParsedNode node) {
      this.node = node;
    }

    Builder name(String called) {
      name = called;
      return this;
    }

    Builder children(List<CountedItem> inside) {
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

    Builder size(Size measured) {
      size = measured;
      return this;
    }

    CountedItem build() {
      return new CountedItem(this);
    }
  }
}
