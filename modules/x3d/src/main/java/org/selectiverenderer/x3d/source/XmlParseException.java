package org.selectiverenderer.x3d.source;

/** Thrown if a text is not well-formed or exceeds a limit. */
public final class XmlParseException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient DocumentError fault;

  XmlParseException(DocumentError fault) {
    super(fault.message());
    this.fault = fault;
  }

  /** Returns the fault with its location. */
  public DocumentError fault() {
    return fault;
  }
}
