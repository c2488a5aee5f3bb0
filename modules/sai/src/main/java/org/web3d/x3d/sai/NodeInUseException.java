package org.web3d.x3d.sai;

/** The node stands in another scene already. */
public class NodeInUseException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public NodeInUseException() {}

  /** An exception that says what is wrong in one sentence. */
  public NodeInUseException(String message) {
    super(message);
  }
}
