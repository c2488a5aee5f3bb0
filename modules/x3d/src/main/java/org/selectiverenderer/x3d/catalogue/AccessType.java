package org.selectiverenderer.x3d.catalogue;

/** The access types of fields, which define their part in the event model (X3D 4.0, 4.4.2.2). */
public enum AccessType {
  /** Has a value given in the file that cannot change. */
  INITIALIZE_ONLY("initializeOnly"),
  /** Receives events, and has no value. */
  INPUT_ONLY("inputOnly"),
  /** Sends events; its value is the last one sent. */
  OUTPUT_ONLY("outputOnly"),
  /** Has a value, and receives and sends events. */
  INPUT_OUTPUT("inputOutput");

  private final String spelling;

  AccessType(String spelling) {
    this.spelling = spelling;
  }

  /** Returns the standard's spelling, for example {@code inputOutput}. */
  public String spelling() {
    return spelling;
  }

  /** Returns whether a file may give the field a value. */
  public boolean initialisable() {
    return this == INITIALIZE_ONLY || this == INPUT_OUTPUT;
  }

  /** Returns whether the field may be the destination of a ROUTE. */
  public boolean acceptsEvents() {
    return this == INPUT_ONLY || this == INPUT_OUTPUT;
  }

  /** Returns whether the field may be the source of a ROUTE. */
  public boolean sendsEvents() {
    return this == OUTPUT_ONLY || this == INPUT_OUTPUT;
  }

  /**
   * Returns the access type of a spelling.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static AccessType of(String spelling) {
    for (AccessType access : values()) {
      if (access.spelling.equals(spelling)) {
        return access;
      }
    }
    throw new IllegalArgumentException("no access type is called " + spelling);
  }
}
