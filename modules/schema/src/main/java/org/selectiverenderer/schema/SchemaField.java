package org.selectiverenderer.schema;

import java.util.Optional;

/**
 * The schema metadata fields, each with the names that are accepted when reading; the first one is
 * written. The thesis uses two sets of names, one in its listings (Figs 42, 43, 47, 52, 77, 78) and
 * one in its text and Fig 40.
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

  /** The node that a field describes. */
  public enum Owner {
    /** A ProximitySensor, which is an area. */
    SENSOR,
    /** A choice of a Switch, which is a version of an object. */
    CHOICE
  }

  private final Owner owner;
  private final String[] spellings;

  SchemaField(Owner owner, String... spellings) {
    this.owner = owner;
    this.spellings = spellings;
  }

  /** Returns the kind of node that the field describes. */
  public Owner owner() {
    return owner;
  }

  /** Returns the name as it is written. */
  public String spelling() {
    return spellings[0];
  }

  /** Returns the field of a name in any accepted spelling, ignoring surrounding spaces. */
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
