package org.web3d.x3d.sai;

/** The connection to a browser in another process cannot be made or has broken. */
public class ConnectionException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public ConnectionException() {}

  /** An exception that says what is wrong in one sentence. */
  public ConnectionException(String message) {
    super(message);
  }
}
