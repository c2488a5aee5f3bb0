package org.web3d.x3d.sai;

/** An imported or exported node is not there, since its file is not loaded. */
public class NodeUnavailableException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public NodeUnavailableException() {}

  /** An exception that says what is wrong in one sentence. */
  public NodeUnavailableException(String message) {
    super(message);
  }
}
