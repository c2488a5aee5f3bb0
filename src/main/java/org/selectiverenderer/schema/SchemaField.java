package org.selectiverenderer.schema;

import java.util.Optional;

/**
 * The names of the metadata, each with the spellings that are read; the first one is written. The
 * thesis has two sets of names: that of its listings (Figs 42, 43, 47, 52, 77, 78) and that of its
 * text and Fig 40.
 */
public enum SchemaField {
  /** The schemas that entering an area activates; on a ProximitySensor. */
  ENTER_TIME_SCHEMA(Owner.SENSOR, "enterTimeSchema", "enterTimeSchemaActivation"),
  /** The schemas that leaving an area activates; on a ProximitySensor. */
  EXIT_TIME_SCHEMA(Owner.SENSOR, "exitTimeSchema", "exitTimeSchemaActivation"),
  /** Consistent, inconsistent or frame; on a choice of a Switch. */
  CONSISTENCY_TYPE(Owner.CHOICE, "consistencyType", "typeOfConsistency"),
  /** Low, high or a number; on a choice of a Switch. */
  DEGREE_OF_CONSISTENCY(Owner.CHOICE, "degreeOfConsistency"),
  /** The schemas that a choice of a Switch belongs to; spelled as in every listing. */
  SCHEMA_BELONGINESS(Owner.CHOICE, "schemaBelonginess");

  /** What a field describes. */
  public enum Owner {
    /** A ProximitySensor: an area. */
    SENSOR,
    /** A child of a Switch: a version of an object. */
    CHOICE
  }

  private final Owner owner;
  private final String[] spellings;

  SchemaField(Owner owner, String... spellings) {
    this.owner = owner;
    this.spellings = spellings;
  }

  /** What the field describes. */
  public Owner owner() {
    return owner;
  }

  /** The name as it is written. */
  public String spelling() {
    return spellings[0];
  }

  /** The field of that name in either spelling, spaces around it aside. */
  public static Optional<SchemaField> of(String name) {
    String stripped = name.strip();
    for (SchemaField field : values()) {
      for (String spelling : field.spellings) {
        if (spelling.equals(stripped)) {
          return Optional.of(field);
        }
      }
    }
    return Optional.empty();
  }
}
