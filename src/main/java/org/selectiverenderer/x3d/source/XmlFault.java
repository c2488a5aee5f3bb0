package org.selectiverenderer.x3d.source;

/** A text is not well formed, or more than a scene may be. */
public final class XmlFault extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient DocumentFault fault;

  XmlFault(DocumentFault fault) {
    super(fault.message());
    this.fault = fault;
  }

  /** What is wrong, and where. */
  public DocumentFault fault() {
    return fault;
  }
}
