package org.web3d.x3d.sai;

/** The browser lacks a profile or component that the content needs. */
public class InsufficientCapabilitiesException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InsufficientCapabilitiesException() {}

  /** An exception that says what is wrong in one sentence. */
  public InsufficientCapabilitiesException(String message) {
    super(message);
  }
}
