package org.web3d.x3d.sai;

/** There is no such route. */
public class InvalidRouteException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidRouteException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidRouteException(String message) {
    super(message);
  }
}
