package org.web3d.x3d.sai;

/**
 * An imported node was used where only a node of the scene itself will do, such as as the child of
 * another node.
 */
public class ImportedNodeException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public ImportedNodeException() {}

  /** An exception that says what is wrong in one sentence. */
  public ImportedNodeException(String message) {
    super(message);
  }
}
