package org.selectiverenderer.x3d.vrml1;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The nodes that count for the next shape. Immutable. */
final class Vrml1State {
  /** The properties, each named as the type of the nodes that set it. */
  enum Property {
    COORDINATES("Coordinate3"),
    NORMALS("Normal"),
    TEXTURE_COORDINATES("TextureCoordinate2"),
    MATERIAL("Material"),
    MATERIAL_BINDING("MaterialBinding"),
    NORMAL_BINDING("NormalBinding"),
    TEXTURE("Texture2"),
    TEXTURE_TRANSFORM("Texture2Transform"),
    SHAPE_HINTS("ShapeHints"),
    FONT_STYLE("FontStyle");

    private final String type;

    Property(String type) {
      this.type = type;
    }

    /** Returns the property that nodes of a type set. */
    static Optional<Property> setBy(String type) {
      return Arrays.stream(values()).filter(found -> found.type.equals(type)).findFirst();
    }
  }

  private final @Nullable Vrml1Node[] nodes;

  /** Creates the state before the first node, in which all defaults count. */
  Vrml1State() {
    this(new @Nullable Vrml1Node[Property.values().length]);
  }

  private Vrml1State(@Nullable Vrml1Node[] nodes) {
    this.nodes = nodes;
  }

  /** Returns the node that sets a property; null if the default counts. */
  @Nullable Vrml1Node get(Property property) {
    return nodes[property.ordinal()];
  }

  Vrml1State with(Property property, @Nullable Vrml1Node node) {
    @Nullable Vrml1Node[] changed = nodes.clone();
    changed[property.ordinal()] = node;
    return new Vrml1State(changed);
  }

  boolean agrees(Vrml1State other, EnumSet<Property> properties) {
    return properties.stream().allMatch(property -> get(property) == other.get(property));
  }

  /** Returns this state after the changes from one state to another. */
  Vrml1State changed(Vrml1State before, Vrml1State after) {
    Vrml1State result = this;
    for (Property property : Property.values()) {
      if (before.get(property) != after.get(property)) {
        result = result.with(property, after.get(property));
      }
    }
    return result;
  }
}
