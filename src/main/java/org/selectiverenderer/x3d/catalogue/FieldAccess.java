package org.selectiverenderer.x3d.catalogue;

/** How a field takes part in the event model (X3D 4.0, 4.4.2.2). */
public enum FieldAccess {
  /** A value given in the file, fixed afterwards. */
  INITIALIZE_ONLY("initializeOnly"),
  /** Receives events, holds no value. */
  INPUT_ONLY("inputOnly"),
  /** Sends events; its value is the last one sent. */
  OUTPUT_ONLY("outputOnly"),
  /** Holds a value, receives and sends events. */
  INPUT_OUTPUT("inputOutput");

  private final String spelling;

  FieldAccess(String spelling) {
    this.spelling = spelling;
  }

  /** The standard's own spelling, for example {@code inputOutput}. */
  public String spelling() {
    return spelling;
  }

  /** Whether a file may give the field a value. */
  public boolean initialisable() {
    return this == INITIALIZE_ONLY || this == INPUT_OUTPUT;
  }

  /** Whether the field may be the end of a ROUTE. */
  public boolean acceptsEvents() {
    return this == INPUT_ONLY || this == INPUT_OUTPUT;
  }

  /** Whether the field may be the start of a ROUTE. */
  public boolean sendsEvents() {
    return this == OUTPUT_ONLY || this == INPUT_OUTPUT;
  }

  /**
   * The access type of that spelling.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static FieldAccess of(String spelling) {
    for (FieldAccess access : values()) {
      if (access.spelling.equals(spelling)) {
        return access;
      }
    }
    throw new IllegalArgumentException("no access type is called " + spelling);
  }
}
