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

  /** Tells what counts now, to those who translate a shape. */
  @FunctionalInterface
  interface Reader {
    /** Returns the node that sets a property; null if the default counts. */
    @Nullable Vrml1Node read(Property property);
  }

  /** One setting of a property; another one differs from it, even by the same node. */
  private static final class Setting {
    final Vrml1Node node;

    Setting(Vrml1Node node) {
      this.node = node;
    }
  }

  private final @Nullable Setting[] settings;

  /** Creates the state before the first node, in which all defaults count. */
  Vrml1State() {
    this(new @Nullable Setting[Property.values().length]);
  }

  private Vrml1State(@Nullable Setting[] settings) {
    this.settings = settings;
  }

  /** Returns the node that sets a property; null if the default counts. */
  @Nullable Vrml1Node get(Property property) {
    Setting setting = settings[property.ordinal()];
    return setting == null ? null : setting.node;
  }

  /** Returns this state with a property set by a node, which may be the one that has set it. */
  Vrml1State with(Property property, Vrml1Node node) {
    @Nullable Setting[] changed = settings.clone();
    changed[property.ordinal()] = new Setting(node);
    return new Vrml1State(changed);
  }

  /** Returns whether a property has not been set between another state and this one. */
  boolean keeps(Property property, Vrml1State other) {
    return settings[property.ordinal()] == other.settings[property.ordinal()];
  }

  boolean agrees(Vrml1State other, EnumSet<Property> properties) {
    return properties.stream().allMatch(property -> get(property) == other.get(property));
  }

  /** Returns this state with all properties set that were set between two others. */
  Vrml1State changed(Vrml1State before, Vrml1State after) {
    Vrml1State result = this;
    for (Property property : Property.values()) {
      Vrml1Node node = after.get(property);
      if (node != null && !after.keeps(property, before)) {
        result = result.with(property, node);
      }
    }
    return result;
  }
}
