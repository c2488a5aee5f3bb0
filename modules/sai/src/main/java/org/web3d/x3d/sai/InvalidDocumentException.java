package org.web3d.x3d.sai;

/** A DOM document is no X3D document. */
public class InvalidDocumentException extends X3DException {
  private static final long serialVersionUID = 1L;

  /** An exception without a message. */
  public InvalidDocumentException() {}

  /** An exception that says what is wrong in one sentence. */
  public InvalidDocumentException(String message) {
    super(message);
  }
}
